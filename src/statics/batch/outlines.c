/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Access to the k-th outline of an array, of a fixed number of vertices or of offsets, and the
 * checks of the array. A last vertex that repeats the first is dropped. */

#include "batch/outlines.h"

#include <stdint.h>

tp_outlines tp_outlines_of(const double *xy, size_t count, size_t vertices) {
  return (tp_outlines){.count = count, .xy = xy, .vertices = vertices};
}

tp_outlines tp_outlines_ragged(const double *xy, size_t count, const size_t *first) {
  return (tp_outlines){.count = count, .xy = xy, .first = first};
}

tp_vertices tp_vertices_open(const double *xy, size_t count) {
  const double *end = xy + 2 * count - 2;
  const bool closes = count > 3 && xy[0] == end[0] && xy[1] == end[1];
  return (tp_vertices){xy, closes ? count - 1 : count};
}

tp_vertices tp_outlines_at(const tp_outlines *outlines, size_t k) {
  const size_t first = outlines->first != NULL ? outlines->first[k] : k * outlines->vertices;
  const size_t count =
      outlines->first != NULL ? outlines->first[k + 1] - first : outlines->vertices;
  if (count == 0) return (tp_vertices){outlines->xy, 0};
  return tp_vertices_open(outlines->xy + 2 * first, count);
}

tp_status tp_outlines_check(const tp_outlines *outlines, const char *call, tp_message *message) {
  if (outlines->count == 0) return TP_OK;
  if (outlines->xy == NULL) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                     "%s: the coordinates of 'outlines' must not be NULL", call);
  }
  if (outlines->first == NULL && outlines->vertices > SIZE_MAX / 16 / outlines->count) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "%s: %zu outlines of %zu vertices are too many for any memory", call,
                     outlines->count, outlines->vertices);
  }
  for (size_t k = 0; outlines->first != NULL && k < outlines->count; k++) {
    if (outlines->first[k] <= outlines->first[k + 1]) continue;
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){0},
                     "%s: outline %zu begins at vertex %zu and the next one at %zu; 'first' must "
                     "not fall",
                     call, k, outlines->first[k], outlines->first[k + 1]);
  }
  return TP_OK;
}
