/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tree of nodes as the text of a scene file, a scalar a line, so that what is complained of a
 * line is known by where its scalar came from. What is read of the text is the tree. */

#include "common/grow.h"
#include "common/outside.h"
#include "output/text.h"
#include "survey/survey.h"

#include <stdlib.h>
#include <string.h>

typedef struct writer {
  tp_scene_text *own;
  tp_text text;
  long room;
  bool failed;
} writer;

/* Does it stand without quotes for itself? */
static bool is_bare(const char *text) {
  static const char within[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                               "_.+*/()^-";
  const char *first = text;
  if (first[0] == '-' || first[0] == '+') first++;
  if (first[0] == '\0' || strchr("-+*/^)", first[0]) != NULL) return false;
  return text[strspn(text, within)] == '\0';
}

static void add_scalar(writer *w, const char *text) {
  if (is_bare(text)) {
    tp_text_add(&w->text, "%s", text);
    return;
  }
  char *plain = tp_plain_new(text);
  w->failed = w->failed || plain == NULL;
  tp_text_append(&w->text, "\"", 1);
  for (const char *c = plain; c != NULL && *c != '\0'; c++) {
    if (*c == '"' || *c == '\\') tp_text_append(&w->text, "\\", 1);
    tp_text_append(&w->text, c, 1);
  }
  tp_text_append(&w->text, "\"", 1);
  free(plain);
}

static void end_line(writer *w, tp_mark mark) {
  tp_text_append(&w->text, "\n", 1);
  tp_origin *lines = tp_grow(w->own->lines, (long)w->own->line_count, &w->room, sizeof *lines);
  if (lines == NULL) {
    w->failed = true;
    return;
  }
  w->own->lines = lines;
  lines[w->own->line_count++] = (tp_origin){mark};
}

/* What stands behind a key or a dash: it begins on its line, or below. Nodes are nested as deep as
 * a file may have them. */
static void add_children(writer *w, const tp_node *node, int indent) {
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    tp_text_add(&w->text, "%*s", indent, "");
    if (node->kind == TP_NODE_MAPPING) {
      add_scalar(w, child->key);
      tp_text_append(&w->text, ":", 1);
    } else {
      tp_text_append(&w->text, "-", 1);
    }
    if (child->kind == TP_NODE_SCALAR) {
      tp_text_append(&w->text, " ", 1);
      add_scalar(w, child->text);
    } else if (child->first == NULL) {
      tp_text_add(&w->text, child->kind == TP_NODE_MAPPING ? " {}" : " []");
    }
    end_line(w, child->mark);
    if (child->kind != TP_NODE_SCALAR) add_children(w, child, indent + 2);
  }
}

bool tp_scene_text_write(tp_scene_text *text, const tp_node *root) {
  writer w = {.own = text};
  add_children(&w, root, 0);
  if (tp_text_finish(&w.text, &text->text) != TP_OK) w.failed = true;
  return !w.failed;
}

void tp_scene_text_clear(tp_scene_text *text) {
  free(text->name);
  free(text->text);
  free(text->lines);
  *text = (tp_scene_text){0};
}
