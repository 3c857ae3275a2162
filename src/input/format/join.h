/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pieces of a drawing joined end to end.
 *
 * Two ends meet where they are the same point, or at most `gap` apart, or no farther apart than the
 * uncertainties of both, of computed ends. They become one point: that of the end that stands in
 * the file rather than of a computed one, and of the piece that comes first. Pieces that are drawn
 * twice count once. Where more than two ends meet there is no telling which go together, and that
 * is refused.
 *
 * Ends are sorted by x, so that n pieces cost n log n, as long as few ends share an x. */

#ifndef TP_FORMAT_JOIN_H
#define TP_FORMAT_JOIN_H

#include "format/drawing.h"

/* Pieces of a drawing, by their numbers in it. */
typedef struct tp_drawing_pieces {
  const tp_drawing *drawing;
  long count;
  const long *items;
} tp_drawing_pieces;

/* Append to `chains` what the pieces make: closed objects as they are, open ones joined, with notes
 * on what was closed or left out. */
TP_MUST_USE tp_status tp_drawing_join(tp_drawing *chains, const tp_drawing_pieces *pieces,
                                      const fmpq_t gap, tp_message *message);

/* How far apart two points are, rounded. */
double tp_drawing_distance(const tp_polyline *one, long k, const tp_polyline *other, long j);

#endif
