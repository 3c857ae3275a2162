/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Layer and name of each role's objects, the first few and each once, cut to whole characters;
 * parts share a tint by layer. */

#include "figure/drawn_names.h"

#include "common/outside.h"
#include "output/encode.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_NAMES = 3, MOST_BYTES = 32 };

/* The first characters of a text. */
static void add_word(tp_text *text, TP_OUTSIDE const char *word) {
  char own[MOST_BYTES + 1];
  const size_t length = strnlen(word, MOST_BYTES + 1);
  const size_t kept = length > MOST_BYTES ? tp_whole_characters(word, MOST_BYTES) : length;
  memcpy(own, word, kept);
  own[kept] = '\0';
  tp_encode_plain(text, own);
  if (kept < length) tp_text_add(text, "…");
}

static void add_name(tp_text *text, const tp_drawn_object *object) {
  const bool layered = object->layer[0] != '\0', named = object->name[0] != '\0';
  if (layered) add_word(text, object->layer);
  if (layered && named) tp_text_add(text, " (");
  if (named) add_word(text, object->name);
  if (layered && named) tp_text_add(text, ")");
  if (!layered && !named) tp_text_add(text, "%s", object->kind);
}

static bool are_alike(const tp_drawn_object *one, const tp_drawn_object *other) {
  return strcmp(one->layer, other->layer) == 0 && strcmp(one->name, other->name) == 0 &&
         (one->layer[0] != '\0' || one->name[0] != '\0' || strcmp(one->kind, other->kind) == 0);
}

/* Each name of a role once; the first few. */
static void add_names(tp_text *text, const char *before, const tp_drawn *drawn,
                      tp_drawing_role role) {
  const tp_drawn_object *known[MOST_NAMES];
  int count = 0;
  for (long k = 0; drawn != NULL && k < drawn->object_count; k++) {
    const tp_drawn_object *own = drawn->objects + k;
    bool told = own->role != role;
    for (int i = 0; i < count && !told; i++) told = are_alike(known[i], own);
    if (told) continue;
    tp_text_add(text, "%s", count == 0 ? before : ", ");
    if (count == MOST_NAMES) {
      tp_text_add(text, "…");
      return;
    }
    known[count++] = own;
    add_name(text, own);
  }
}

/* The parts of a block are first those that the scene gives itself, then those of its drawing. */
int tp_part_tint(const tp_scene *scene, long part) {
  const tp_drawn *drawn = scene->drawn;
  const long own = drawn != NULL ? scene->block.part_count - drawn->part_count : part + 1;
  const long turn = part < own ? part : own + drawn->part_words[part - own];
  return (int)(turn % TP_TINTS_OF_PARTS);
}

/* The layers of the parts that are drawn in a tint. */
static void add_layers(tp_text *text, const tp_scene *scene, int tint) {
  const tp_drawn *drawn = scene->drawn;
  long known[MOST_NAMES];
  int count = 0;
  const long own = drawn != NULL ? scene->block.part_count - drawn->part_count : 0;
  for (long k = 0; drawn != NULL && k < drawn->part_count; k++) {
    bool told = tp_part_tint(scene, own + k) != tint;
    for (int i = 0; i < count && !told; i++) told = known[i] == drawn->part_words[k];
    if (told) continue;
    tp_text_add(text, "%s", count == 0 ? ": " : ", ");
    if (count == MOST_NAMES) {
      tp_text_add(text, "…");
      return;
    }
    known[count++] = drawn->part_words[k];
    add_word(text, drawn->part_layers[k]);
  }
}

bool tp_drawn_names_init(tp_drawn_names *names, const tp_figure *figure) {
  const tp_scene *scene = figure->problem->scene;
  const tp_drawn *drawn = scene->drawn;
  memset(names, 0, sizeof *names);
  tp_text_add(&names->block, "%s", tp_figure_word(figure, "block"));
  add_names(&names->block, ": ", drawn, TP_DRAWING_BLOCK);
  tp_text_add(&names->base, "%s", tp_figure_word(figure, "base"));
  add_names(&names->base, ": ", drawn, TP_DRAWING_BASE);
  tp_text_add(&names->hole, "%s", tp_figure_word(figure, "hole"));
  add_names(&names->hole, ": ", drawn, TP_DRAWING_HOLE);
  tp_text_add(names->parts, "%s", tp_figure_word(figure, "of other density"));
  tp_text_add(names->parts + 1, "%s", tp_figure_word(figure, "of another"));
  for (long k = 0; k < scene->block.part_count; k++) {
    names->has_part[tp_part_tint(scene, k)] = true;
  }
  for (int tint = 0; tint < TP_TINTS_OF_PARTS; tint++) {
    add_layers(names->parts + tint, scene, tint);
  }
  tp_text_add(&names->unused, "%s", ""); /* a text in any case */
  tp_text unused = {0};
  tp_text_add(&unused, "%s: ", tp_figure_word(figure, "Not used of the drawing"));
  add_names(&names->unused, unused.failed ? "" : unused.data, drawn, TP_DRAWING_UNUSED);
  names->unused.failed = names->unused.failed || unused.failed;
  tp_text_drop(&unused);
  return !(names->block.failed || names->base.failed || names->hole.failed ||
           names->parts[0].failed || names->parts[1].failed || names->unused.failed);
}

void tp_drawn_names_clear(tp_drawn_names *names) {
  free(names->block.data);
  free(names->base.data);
  free(names->hole.data);
  for (int tint = 0; tint < TP_TINTS_OF_PARTS; tint++) free(names->parts[tint].data);
  free(names->unused.data);
}
