/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moves all of the block that lies near its profile onto it (base/snap.h): near vertices, corners
 * that fit each other, moved vertices, points of the profile taken in, and the extent, in that
 * order. */

#include "base/snap_search.h"

#include <stdlib.h>

static bool search_init(tp_snap_search *s, const tp_closeness *near, const fmpq_t within) {
  *s = (tp_snap_search){.near = near, .outline = near->section->rings, .ring = &near->base->ring};
  fmpq_init(s->limit);
  fmpq_mul(s->limit, within, within);
  s->of_vertex = malloc((size_t)s->outline->count * sizeof *s->of_vertex);
  s->of_point = malloc((size_t)near->points * sizeof *s->of_point);
  s->has_vertex = calloc((size_t)near->points, sizeof *s->has_vertex);
  if (s->of_vertex == NULL || s->of_point == NULL || s->has_vertex == NULL) return false;
  for (long k = 0; k < s->outline->count; k++) s->of_vertex[k] = -1;
  for (long k = 0; k < near->points; k++) s->of_point[k] = -1;
  return true;
}

static void search_clear(tp_snap_search *s) {
  for (long k = 0; k < s->count; k++) {
    fmpq_clear(s->feet[k].share);
    fmpq_clear(s->feet[k].square);
    fmpq_clear(s->feet[k].corner_square);
  }
  fmpq_clear(s->limit);
  free(s->feet);
  free(s->of_vertex);
  free(s->of_point);
  free(s->has_vertex);
  free(s->points);
}

bool tp_snap_find(tp_snap *snap, const tp_closeness *near, const fmpq_t within) {
  tp_snap_search s;
  const tp_closeness_reach reach = {.within = fmpq_get_d(within) / near->unit * (1 + 0x1p-50)};
  bool done = search_init(&s, near, within) && tp_closeness_visit(near, &reach, tp_snap_take, &s);
  for (long k = 0; k < s.count && done; k++) {
    const tp_snap_foot *f = s.feet + k;
    if (tp_snap_is_inside(&s, f) && fmpq_cmp(f->square, snap->overlap) > 0) {
      fmpq_set(snap->overlap, f->square);
    }
  }
  snap->touches = s.count > 0;
  done = done && tp_snap_settle_corners(&s);
  if (done) tp_snap_normalise(&s);
  done =
      done && tp_snap_move_vertices(snap, &s) && tp_snap_list_points(&s) && tp_snap_build(snap, &s);
  if (done) tp_snap_find_extent(snap, &s);
  search_clear(&s);
  return done;
}
