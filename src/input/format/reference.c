/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finds the reference object by name or layer, measures it in rationals, and scales all objects by
 * an affine map (format/affine.h). */

#include "format/reference.h"

#include "common/outside.h"
#include "format/affine.h"
#include "format/curve.h"

#include <strings.h>

/* The object of the name; NULL with `*count` where there is none, or there are several. */
static tp_drawing_object *find(const tp_drawing *drawing, const char *name, long *count) {
  tp_drawing_object *found = NULL;
  *count = 0;
  for (int pass = 0; pass < 2 && *count == 0; pass++) { /* by name, then by layer */
    for (long k = 0; k < drawing->count; k++) {
      tp_drawing_object *object = drawing->objects + k;
      if (strcasecmp(pass == 0 ? object->name : object->layer, name) != 0) continue;
      found = object;
      (*count)++;
    }
  }
  return *count == 1 ? found : NULL;
}

/* The square root, exactly where it is rational. */
static void set_root(fmpq_t root, const fmpq_t square) {
  enum { BITS = 256 };
  if (fmpz_is_square(fmpq_numref(square)) && fmpz_is_square(fmpq_denref(square))) {
    fmpz_sqrt(fmpq_numref(root), fmpq_numref(square));
    fmpz_sqrt(fmpq_denref(root), fmpq_denref(square));
    return;
  }
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, square, BITS);
  arb_sqrt(ball, ball, BITS);
  tp_curve_decimal(root, ball);
  arb_clear(ball);
}

static void measure(fmpq_t length, const tp_drawing_object *object) {
  const tp_polyline *line = &object->line;
  fmpq_t other;
  fmpq_init(other);
  if (object->closure == TP_DRAWING_CLOSED) {
    tp_polyline_size(length, other, line);
    if (fmpq_cmp(other, length) > 0) fmpq_swap(other, length);
  } else {
    fmpq_sub(length, line->x + line->count - 1, line->x);
    fmpq_sub(other, line->y + line->count - 1, line->y);
    fmpq_mul(length, length, length);
    fmpq_addmul(length, other, other);
    set_root(length, length);
  }
  fmpq_clear(other);
}

tp_status tp_drawing_scale(tp_drawing *drawing, const tp_drawing_options *options,
                           tp_message *message) {
  if (options->reference == NULL) return TP_OK;
  long count = 0;
  tp_drawing_object *object = find(drawing, options->reference, &count);
  if (object == NULL || object->line.count == 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){drawing->path, 0, 0},
                     count == 0 ? "nothing of the drawing is called '%s', the id of the reference"
                                : "several objects of the drawing are called '%s', the id of the "
                                  "reference; it must be one",
                     tp_quote_all(options->reference).text);
  }
  tp_affine_map map;
  fmpq_t factor;
  tp_affine_map_init(&map);
  fmpq_init(factor);
  measure(factor, object);
  const tp_place place = tp_drawing_place(object);
  const bool measured = fmpq_sgn(factor) > 0;
  if (measured) {
    fmpq_div(factor, options->length, factor);
    tp_affine_map_scale(&map, factor, factor);
    tp_drawing_remove(drawing, object - drawing->objects);
    for (long k = 0; k < drawing->count; k++) tp_affine_map_object(drawing->objects + k, &map);
  }
  tp_affine_map_clear(&map);
  fmpq_clear(factor);
  return measured
             ? TP_OK
             : tp_refuse(message, TP_FAULT_GEOMETRY, place,
                         "the reference is no longer than zero, so it cannot scale the drawing");
}
