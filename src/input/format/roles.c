/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Roles by layer or name, or by closure where no name says so; pieces of one role are joined and
 * checked, and what is ambiguous is refused with a list of the layers. */

#include "format/roles.h"

#include "common/outside.h"
#include "format/join.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct choosing {
  tp_drawing_choice *choice;
  const tp_drawing *drawing;
  const tp_drawing_words *words;
  tp_place place;
  tp_message *message;
} choosing;

static bool are(const char *layer, const char *name, const char *word) {
  if (word == NULL) return false;
  return strcasecmp(layer, word) == 0 || strcasecmp(name, word) == 0;
}

/* Which of the parts' words; -1: none. */
static long part_by(const tp_drawing_words *words, const char *layer, const char *name) {
  for (long k = 0; k < words->part_count; k++) {
    if (are(layer, name, words->parts[k])) return k;
  }
  return -1;
}

tp_drawing_role tp_drawing_role_by(const tp_drawing_words *words, const char *layer,
                                   const char *name) {
  if (part_by(words, layer, name) >= 0) return TP_DRAWING_PART;
  if (are(layer, name, words->block)) return TP_DRAWING_BLOCK;
  if (are(layer, name, words->base)) return TP_DRAWING_BASE;
  return are(layer, name, words->hole) ? TP_DRAWING_HOLE : TP_DRAWING_UNUSED;
}

/* ---- by layers ---------------------------------------------------------------------------------
 */

/* An inner ring of the block is a hole, of anything else what its outer ring is, and no block. */
static void give_roles(choosing *c) {
  for (long k = 0; k < c->drawing->count; k++) {
    const tp_drawing_object *object = c->drawing->objects + k;
    tp_drawing_role role = tp_drawing_role_by(c->words, object->layer, object->name);
    if (object->ring_of >= 0) {
      const bool of_block = c->choice->objects[object->ring_of] == TP_DRAWING_BLOCK;
      role = of_block ? TP_DRAWING_HOLE : TP_DRAWING_UNUSED;
    }
    c->choice->objects[k] = role;
  }
}

static long count_role(const choosing *c, tp_drawing_role role) {
  long count = 0;
  for (long k = 0; k < c->drawing->count; k++) count += c->choice->objects[k] == role;
  return count;
}

/* "ROCK (2 closed), 0 (14 open)", of the first few layers. */
static void list_layers(char *text, size_t size, const tp_drawing *drawing) {
  enum { MOST = 8 };
  size_t at = 0;
  int listed = 0;
  text[0] = '\0';
  for (long k = 0; k < drawing->count && listed <= MOST; k++) {
    const char *layer = drawing->objects[k].layer;
    long closed = 0, open = 0, before = 0;
    for (long i = 0; i < drawing->count; i++) {
      if (strcasecmp(drawing->objects[i].layer, layer) != 0) continue;
      before += i < k;
      closed += drawing->objects[i].closure == TP_DRAWING_CLOSED;
      open += drawing->objects[i].closure != TP_DRAWING_CLOSED;
      if (before > 0) break;
    }
    if (before > 0) continue;
    const int wrote = listed++ == MOST
                          ? snprintf(text + at, size - at, ", …")
                          : snprintf(text + at, size - at, "%s'%s' (%ld closed, %ld open)",
                                     at > 0 ? ", " : "", tp_quote_of(layer, 40).text, closed, open);
    at += wrote > 0 ? (size_t)wrote : 0;
    if (at >= size) return;
  }
}

static tp_status fail_no_block(const choosing *c) {
  char layers[600], hidden[80] = "";
  list_layers(layers, sizeof layers, c->drawing);
  if (c->drawing->hidden > 0) {
    snprintf(hidden, sizeof hidden, "; what is not shown is left out (%ld of its objects)",
             c->drawing->hidden);
  }
  if (c->drawing->count == 0) {
    return tp_refuse(c->message, TP_FAULT_GEOMETRY, (tp_place){c->drawing->path, 0, 0},
                     "the drawing has no lines, arcs or curves that could be an outline%s", hidden);
  }
  return tp_refuse(c->message, TP_FAULT_KEY, (tp_place){c->drawing->path, 0, 0},
                   "nothing is on layer '%s', so there is no block; the drawing has %s; say which "
                   "it is: drawing: {block: LAYER}%s",
                   tp_quote_all(c->words->block).text, layers, hidden);
}

/* ---- where no layer is named -------------------------------------------------------------------
 */

/* A place of the only object of a closure, among chains that are no inner rings; -1 and how many.
 */
static long only(const tp_drawing *chains, bool closed, long *count) {
  long found = -1;
  *count = 0;
  for (long k = 0; k < chains->count; k++) {
    const tp_drawing_object *object = chains->objects + k;
    const bool own = object->closure != TP_DRAWING_OPEN;
    if (own != closed || object->ring_of >= 0) continue;
    found = k;
    (*count)++;
  }
  return *count == 1 ? found : -1;
}

/* The role of a chain goes to all objects that end in it: those of its kind of closure. */
static void spread(choosing *c, bool has_base) {
  for (long k = 0; k < c->drawing->count; k++) {
    const tp_drawing_object *object = c->drawing->objects + k;
    tp_drawing_role *role = c->choice->objects + k;
    *role = object->ring_of >= 0 ? TP_DRAWING_HOLE : TP_DRAWING_BLOCK;
    if (has_base && object->closure == TP_DRAWING_OPEN) *role = TP_DRAWING_BASE;
  }
}

/* The only closed outline, and the only open line. */
static tp_status choose_only(choosing *c) {
  tp_drawing all;
  tp_drawing_init(&all, c->drawing->path);
  long *items = calloc((size_t)c->drawing->count + 1, sizeof *items);
  if (items == NULL) return tp_fail_memory(c->message, "a drawing");
  for (long k = 0; k < c->drawing->count; k++) items[k] = k;
  const tp_drawing_pieces pieces = {c->drawing, c->drawing->count, items};
  tp_message unused = {.text = ""};
  tp_status status = tp_drawing_join(&all, &pieces, c->words->gap, &unused);
  long closed = 0, open = 0;
  const bool found = status == TP_OK && only(&all, true, &closed) >= 0;
  const bool base = only(&all, false, &open) >= 0;
  /* lines that close to the block are open themselves: then they are all of it */
  bool closed_by_itself = false;
  for (long k = 0; k < c->drawing->count; k++) {
    closed_by_itself |= c->drawing->objects[k].closure != TP_DRAWING_OPEN;
  }
  tp_drawing_clear(&all);
  free(items);
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(c->message, "a drawing");
  if (!found || open > 1 || (base && !closed_by_itself)) return fail_no_block(c);
  spread(c, base);
  long outer = 0;
  for (long k = 0; k < c->drawing->count; k++) outer += c->drawing->objects[k].ring_of < 0;
  if (outer == 1) return TP_OK; /* there is nothing else that it could be */
  return tp_notes_add(
      &c->choice->chains.notes, c->message, TP_NOTE, (tp_place){c->drawing->path, 0, 0},
      "nothing is on layer '%s': the only closed outline is taken for the block%s",
      tp_quote_all(c->words->block).text, base ? ", and the only open line for its base" : "");
}

static tp_status check_only(const choosing *c, tp_drawing_role role) {
  return tp_role_check_only(&c->choice->chains, c->choice->roles, role, c->message);
}

/* Copies of inner rings lose their outer one, which is no object of the chains. */
static tp_status add_role(choosing *c, tp_drawing_role role, long part) {
  long *items = calloc((size_t)c->drawing->count + 1, sizeof *items);
  if (items == NULL) return tp_fail_memory(c->message, "a drawing");
  tp_drawing_pieces pieces = {c->drawing, 0, items};
  for (long k = 0; k < c->drawing->count; k++) {
    const tp_drawing_object *own = c->drawing->objects + k;
    if (c->choice->objects[k] != role) continue;
    if (role == TP_DRAWING_PART && part_by(c->words, own->layer, own->name) != part) continue;
    items[pieces.count++] = k;
  }
  const long before = c->choice->chains.count;
  tp_status status = tp_drawing_join(&c->choice->chains, &pieces, c->words->gap, c->message);
  free(items);
  const size_t count = (size_t)c->choice->chains.count;
  tp_drawing_role *roles = realloc(c->choice->roles, (count + 1) * sizeof *roles);
  if (roles != NULL) c->choice->roles = roles;
  long *parts = realloc(c->choice->parts, (count + 1) * sizeof *parts);
  if (parts != NULL) c->choice->parts = parts;
  if (roles == NULL || parts == NULL) return tp_fail_memory(c->message, "a drawing");
  for (long k = before; k < c->choice->chains.count; k++) {
    roles[k] = role;
    parts[k] = part;
  }
  for (long k = before; k < c->choice->chains.count && status == TP_OK; k++) {
    status = tp_role_check(&c->choice->chains, c->choice->chains.objects + k, role, c->message);
  }
  return status;
}

static tp_status choose(choosing *c) {
  tp_status status = TP_OK;
  give_roles(c);
  const bool of_block = c->words->block != NULL;
  if (of_block && count_role(c, TP_DRAWING_BLOCK) == 0) {
    status = c->words->block_chosen || count_role(c, TP_DRAWING_BASE) > 0 ||
                     count_role(c, TP_DRAWING_HOLE) > 0
                 ? fail_no_block(c)
                 : choose_only(c);
  }
  if (status == TP_OK) status = add_role(c, TP_DRAWING_BLOCK, -1);
  if (status == TP_OK && of_block) status = check_only(c, TP_DRAWING_BLOCK);
  if (status == TP_OK) status = add_role(c, TP_DRAWING_BASE, -1);
  if (status == TP_OK && of_block) status = check_only(c, TP_DRAWING_BASE);
  if (status == TP_OK) status = add_role(c, TP_DRAWING_HOLE, -1);
  for (long k = 0; k < c->words->part_count && status == TP_OK; k++) {
    status = add_role(c, TP_DRAWING_PART, k);
  }
  for (long k = 0; k < c->choice->chains.count && status == TP_OK; k++) {
    if (!tp_role_finish(c->choice->chains.objects + k, c->choice->roles[k])) {
      status = tp_fail_memory(c->message, "a drawing");
    }
  }
  return status;
}

/* A layer that the scene names and the drawing has not is a slip. */
static tp_status check_named(const choosing *c) {
  const struct {
    bool chosen;
    const char *word;
    tp_drawing_role role;
  } named[] = {{c->words->base_chosen, c->words->base, TP_DRAWING_BASE},
               {c->words->hole_chosen, c->words->hole, TP_DRAWING_HOLE}};
  for (int k = 0; k < 2; k++) {
    if (!named[k].chosen || count_role(c, named[k].role) > 0) continue;
    return tp_refuse(c->message, TP_FAULT_KEY, c->place, "nothing of the drawing is on layer '%s'",
                     tp_quote_all(named[k].word).text);
  }
  for (long k = 0; k < c->words->part_count; k++) {
    bool found = false;
    for (long i = 0; i < c->drawing->count; i++) {
      const tp_drawing_object *own = c->drawing->objects + i;
      found = found || (c->choice->objects[i] == TP_DRAWING_PART &&
                        part_by(c->words, own->layer, own->name) == k);
    }
    if (found) continue;
    return tp_refuse(c->message, TP_FAULT_KEY, c->place, "nothing of the drawing is on layer '%s'",
                     tp_quote_all(c->words->parts[k]).text);
  }
  return TP_OK;
}

tp_status tp_drawing_choose(tp_drawing_choice *choice, const tp_drawing *drawing,
                            const tp_drawing_words *words, tp_place place, tp_message *message) {
  *choice =
      (tp_drawing_choice){.objects = calloc((size_t)drawing->count + 1, sizeof *choice->objects)};
  tp_drawing_init(&choice->chains, drawing->path);
  choice->chains.points_allowed = drawing->points_allowed;
  choosing c = {choice, drawing, words, place, message};
  tp_status status = choice->objects != NULL ? choose(&c) : tp_fail_memory(message, "a drawing");
  if (status == TP_OK) status = check_named(&c);
  if (status != TP_OK) tp_drawing_choice_clear(choice);
  return status;
}

void tp_drawing_choice_clear(tp_drawing_choice *choice) {
  tp_drawing_clear(&choice->chains);
  free(choice->roles);
  free(choice->parts);
  free(choice->objects);
  *choice = (tp_drawing_choice){.roles = NULL};
}
