/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Growing lists of objects, points and bulges of a drawing. */

#include "format/drawing.h"

#include "format/rise.h"

#include "common/budget.h"
#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

void tp_drawing_options_init(tp_drawing_options *options) {
  *options = (tp_drawing_options){.reference = NULL};
  fmpq_init(options->tolerance);
  fmpq_init(options->length);
}

void tp_drawing_options_clear(tp_drawing_options *options) {
  fmpq_clear(options->tolerance);
  fmpq_clear(options->length);
}

void tp_drawing_init(tp_drawing *drawing, const char *path) {
  *drawing = (tp_drawing){.path = path, .points_allowed = TP_BUDGET_DRAWN_POINTS};
}

void tp_drawing_straighten(tp_drawing_object *object) {
  for (long k = 0; k < object->bulge_room; k++) fmpq_clear(object->bulges + k);
  free(object->bulges);
  object->bulges = NULL;
  object->bulge_room = 0;
}

static void clear_object(tp_drawing_object *object) {
  tp_drawing_straighten(object);
  fmpq_clear(object->uncertainty);
  fmpq_clear(object->deviation);
  tp_polyline_clear(&object->line);
  tp_rise_free(object->rise);
  free(object->layer);
  free(object->name);
}

void tp_drawing_clear(tp_drawing *drawing) {
  while (drawing->count > 0) tp_drawing_drop(drawing);
  free(drawing->objects);
  tp_notes_clear(&drawing->notes);
  tp_drawing_init(drawing, drawing->path);
}

tp_drawing_object *tp_drawing_add(tp_drawing *drawing, const char *kind, const char *layer,
                                  const char *name, tp_mark mark) {
  tp_drawing_object *objects =
      tp_grow(drawing->objects, drawing->count, &drawing->room, sizeof *objects);
  if (objects == NULL) return NULL;
  drawing->objects = objects;
  tp_drawing_object *object = objects + drawing->count++;
  *object = (tp_drawing_object){.kind = kind,
                                .layer = strdup(layer != NULL ? layer : ""),
                                .name = strdup(name != NULL ? name : ""),
                                .pieces = 1,
                                .ring_of = -1,
                                .most_points = drawing->points_allowed,
                                .line = {.file = drawing->path, .mark = mark}};
  fmpq_init(object->uncertainty);
  fmpq_init(object->deviation);
  if (object->layer != NULL && object->name != NULL) return object;
  tp_drawing_drop(drawing);
  return NULL;
}

void tp_drawing_drop(tp_drawing *drawing) {
  clear_object(drawing->objects + --drawing->count);
}

void tp_drawing_remove(tp_drawing *drawing, long number) {
  clear_object(drawing->objects + number);
  drawing->count--;
  for (long k = number; k < drawing->count; k++) drawing->objects[k] = drawing->objects[k + 1];
  for (long k = 0; k < drawing->count; k++) {
    if (drawing->objects[k].ring_of > number) drawing->objects[k].ring_of--;
  }
}

bool tp_drawing_add_point(tp_drawing_object *object, const fmpq_t x, const fmpq_t y, tp_mark mark) {
  return tp_polyline_append(&object->line, x, y, mark);
}

/* Room for the bulges of so many edges. */
static bool reserve_bulges(tp_drawing_object *object, long room) {
  if (room <= object->bulge_room) return true;
  fmpq *bulges = realloc(object->bulges, (size_t)room * sizeof *bulges);
  if (bulges == NULL) return false;
  for (long k = object->bulge_room; k < room; k++) fmpq_init(bulges + k);
  object->bulges = bulges;
  object->bulge_room = room;
  return true;
}

bool tp_drawing_bend(tp_drawing_object *object, const fmpq_t bulge) {
  const long edge = object->line.count - 1;
  if (edge >= object->bulge_room && !reserve_bulges(object, object->line.capacity)) return false;
  fmpq_set(object->bulges + edge, bulge);
  return true;
}

const fmpq *tp_drawing_bulge(const tp_drawing_object *object, long edge) {
  if (edge >= object->bulge_room || fmpq_is_zero(object->bulges + edge)) return NULL;
  return object->bulges + edge;
}

static void raise_bound(fmpq_t bound, const fmpq_t other) {
  if (fmpq_cmp(other, bound) > 0) fmpq_set(bound, other);
}

bool tp_drawing_append(tp_drawing_object *object, const tp_drawing_object *more) {
  const tp_polyline *line = &more->line;
  bool done = true;
  for (long k = 0; k < line->count && done; k++) {
    const fmpq *bulge = tp_drawing_bulge(more, k);
    done = tp_drawing_add_point(object, line->x + k, line->y + k, line->marks[k]) &&
           (bulge == NULL || tp_drawing_bend(object, bulge));
  }
  object->closure = more->closure;
  object->problem = more->problem;
  raise_bound(object->uncertainty, more->uncertainty);
  raise_bound(object->deviation, more->deviation);
  return done;
}

bool tp_drawing_has_arcs(const tp_drawing_object *object) {
  for (long k = 0; k < object->line.count; k++) {
    if (tp_drawing_bulge(object, k) != NULL) return true;
  }
  return false;
}

static bool same_point(const tp_polyline *line, long one, long other) {
  return fmpq_equal(line->x + one, line->x + other) && fmpq_equal(line->y + one, line->y + other);
}

static void swap_points(tp_drawing_object *object, long one, long other) {
  tp_polyline *line = &object->line;
  const tp_mark mark = line->marks[one];
  fmpq_swap(line->x + one, line->x + other);
  fmpq_swap(line->y + one, line->y + other);
  line->marks[one] = line->marks[other];
  line->marks[other] = mark;
}

void tp_drawing_drop_point(tp_drawing_object *object) {
  tp_polyline *line = &object->line;
  const long last = --line->count;
  fmpq_clear(line->x + last);
  fmpq_clear(line->y + last);
  if (last < object->bulge_room) fmpq_zero(object->bulges + last);
}

/* The edge of one point becomes that of the other. */
static void move_edge(tp_drawing_object *object, long to, long from) {
  const fmpq *bulge = tp_drawing_bulge(object, from);
  if (to >= object->bulge_room) return; /* then `from`, behind it, is straight, too */
  if (bulge != NULL) {
    fmpq_set(object->bulges + to, bulge);
  } else {
    fmpq_zero(object->bulges + to);
  }
}

void tp_drawing_tidy(tp_drawing_object *object) {
  tp_polyline *line = &object->line;
  long kept = line->count > 0 ? 1 : 0;
  for (long k = kept; k < line->count; k++) {
    if (same_point(line, kept - 1, k)) {
      move_edge(object, kept - 1, k);
      continue;
    }
    if (kept != k) {
      swap_points(object, kept, k);
      move_edge(object, kept, k);
    }
    kept++;
  }
  while (line->count > kept) tp_drawing_drop_point(object);
  if (line->count < 3 || !same_point(line, 0, line->count - 1)) return;
  tp_drawing_drop_point(object);
  object->closure = TP_DRAWING_CLOSED;
}

bool tp_drawing_reverse(tp_drawing_object *object) {
  const long count = object->line.count;
  if (tp_drawing_has_arcs(object)) {
    if (!reserve_bulges(object, count)) return false;
    /* the edge from k ran from n - 1 - k back to the point before it; the closing one stays last */
    fmpq *bulges = object->bulges;
    for (long k = 0; k < count - 2 - k; k++) fmpq_swap(bulges + k, bulges + count - 2 - k);
    for (long k = 0; k < count; k++) fmpq_neg(bulges + k, bulges + k);
  }
  for (long k = 0; k < count - 1 - k; k++) swap_points(object, k, count - 1 - k);
  return true;
}

tp_place tp_drawing_place(const tp_drawing_object *object) {
  return (tp_place){object->line.file, object->line.mark.line, object->line.mark.column};
}
