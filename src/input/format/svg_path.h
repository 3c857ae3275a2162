/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The data of an SVG path, lists of numbers and transforms, in exact numbers. */

#ifndef TP_FORMAT_SVG_PATH_H
#define TP_FORMAT_SVG_PATH_H

#include "format/affine.h"
#include "format/curve.h"
#include "format/drawing.h"

/* A text that is read from its beginning on. */
typedef struct tp_svg_text {
  const char *at, *end;
  const char *problem; /* static; NULL: none so far */
} tp_svg_text;

/* The next number, after blanks and a comma; false where there is none, or with the problem set. */
bool tp_svg_number(tp_svg_text *text, fmpq_t value);
bool tp_svg_at_number(tp_svg_text *text);

/* The map of a "transform" inside `map`. False with the problem set. */
bool tp_svg_transform(tp_affine_map *map, tp_svg_text *text);

/* What a map does, before a turn by an angle in degrees: exact for quarters of a turn, else with
 * cosine and sine within 1e-18. */
void tp_svg_turn(tp_affine_map *map, const fmpq_t degrees);

/* Where the objects of an element go. */
typedef struct tp_svg_target {
  tp_drawing *drawing;
  const char *kind, *layer, *name;
  tp_mark mark;
  const tp_drawing_options *options;
  const tp_affine_map *map; /* to where the drawing has it */
  bool no_memory;
  tp_status status; /* TP_OK; else with the message */
  tp_message *message;
} tp_svg_target;

/* An object of an element, mapped: arcs that the map does not keep become chords before. It is the
 * last of the drawing. */
bool tp_svg_finish(tp_svg_target *target, tp_drawing_object *object);
tp_drawing_object *tp_svg_begin(tp_svg_target *target);

/* The tolerance for a curve of a size, before it is mapped. False where it has none. */
bool tp_svg_tolerance(fmpq_t tolerance, const tp_svg_target *target, const fmpq_t size);

/* Objects of path data, one for each M. False with the problem set, or with no memory. */
bool tp_svg_path(tp_svg_target *target, tp_svg_text *text);

/* The arc of a path's command A behind the last point of the object (format/svg_arc.c): half-axes,
 * the angle of the first to x in degrees, which of four, and its end. */
typedef struct tp_svg_arc {
  fmpq_t rx, ry, degrees, x, y;
  bool large, sweep;
} tp_svg_arc;

bool tp_svg_add_arc(tp_svg_target *target, tp_drawing_object *object, tp_svg_arc *arc);

#endif
