/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chain of exact points in scene lengths, each with the place in a file that it came from. */

#ifndef TP_PLANE_POLYLINE_H
#define TP_PLANE_POLYLINE_H

#include "common/message.h"

#include <flint/fmpq.h>
#include <stdatomic.h>

typedef struct tp_mark {
  int line, column;
} tp_mark;

typedef struct tp_polyline {
  const char *file; /* borrowed from the scene; NULL: made by the program */
  tp_mark mark;     /* where the chain as a whole stands */
  long count, capacity;
  fmpq *x, *y;
  tp_mark *marks;
  bool reversed;      /* stored against the order in which it was written */
  atomic_long *users; /* chains that share the points; NULL: they are of this one alone */
} tp_polyline;

void tp_polyline_clear(tp_polyline *line);

/* Some of them, each of the list's own. */
typedef struct tp_polylines {
  long count;
  tp_polyline *lines;
} tp_polylines;

void tp_polylines_clear(tp_polylines *lines);

/* Make room for `count` points in all; append a point. False when memory is exhausted. */
TP_MUST_USE bool tp_polyline_reserve(tp_polyline *line, long count);
TP_MUST_USE bool tp_polyline_append(tp_polyline *line, const fmpq_t x, const fmpq_t y,
                                    tp_mark mark);
TP_MUST_USE bool tp_polyline_copy(tp_polyline *copy, const tp_polyline *line);

/* From now on the points stay as they are, and other chains may share them, in other threads too:
 * the last to be cleared gives them back. False when memory is exhausted. */
TP_MUST_USE bool tp_polyline_make_shared(tp_polyline *line);
/* Give a chain that shares its points some of its own, which may be changed until they are shared.
 */
TP_MUST_USE bool tp_polyline_separate(tp_polyline *line);
/* Another chain of the same points; `line` was made shared, or has none. */
tp_polyline tp_polyline_share(const tp_polyline *line);

/* Width and height of the box around the points, both at least zero. */
void tp_polyline_size(fmpq_t width, fmpq_t height, const tp_polyline *line);

/* Drop the last point where it equals the first, unless that leaves fewer than three. */
void tp_polyline_drop_closing_point(tp_polyline *line);

void tp_polyline_reverse(tp_polyline *line);

/* Number of a vertex as its author counts it, from 1 in the order of writing. */
long tp_polyline_number(const tp_polyline *line, long index);
tp_place tp_polyline_place(const tp_polyline *line, long index);

/* Index of the leftmost vertex, the lowest of them. A simple closed chain turns there, which gives
 * its orientation from three points: tp_polyline_orientation is 1 for counter-clockwise, -1 for
 * clockwise, 0 where the chain folds back on itself. */
long tp_polyline_leftmost(const tp_polyline *line);
int tp_polyline_orientation(const tp_polyline *line);

/* Sign of (q - p) x (r - p): above zero where r lies left of the line from p to q. */
int tp_points_turn(const fmpq *px, const fmpq *py, const fmpq *qx, const fmpq *qy, const fmpq *rx,
                   const fmpq *ry);
/* The same of three points of a chain. */
int tp_polyline_turn(const tp_polyline *line, long from, long to, long vertex);

/* Turn the closed chain counter-clockwise. */
void tp_polyline_orient(tp_polyline *line);

/* Likewise by the area, of chords that need not make a simple ring: their arcs do. False: there is
 * none. */
bool tp_polyline_orient_by_area(tp_polyline *line);

#endif
