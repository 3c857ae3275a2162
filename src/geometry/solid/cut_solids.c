/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Into how many solids a plane parts what lies above it.
 *
 * With its mirror image below the plane, what lies above is a solid whose surface is made of the
 * pieces that were cut off, each joined with its image. Every solid of it is bounded by one piece
 * from outside, of a volume above zero, and by any number of others from within, of volumes below
 * it: so there are as many solids as pieces of a volume above zero. A piece hangs together over
 * edges above the plane; volumes are those of solid_sums.h. */

#include "solid/cut.h"
#include "solid/sides.h"
#include "solid/solid_sums.h"

#include <stdlib.h>
#include <string.h>

static bool is_on_plane(const tp_surface *surface, const fmpz *up, int vertex) {
  const fmpz *own = surface->whole + 3L * vertex;
  fmpz_t height;
  fmpz_init(height);
  fmpz_mul(height, up, own);
  fmpz_addmul(height, up + 1, own + 1);
  fmpz_addmul(height, up + 2, own + 2);
  const bool is_on = fmpz_is_zero(height);
  fmpz_clear(height);
  return is_on;
}

/* Triangles joined over all edges that do not lie in the plane. */
static bool join(int *leaders, const tp_surface *surface, const fmpz *up) {
  tp_sides sides;
  const bool done =
      tp_sides_init(&sides, surface->triangles, surface->triangle_count, surface->vertex_count);
  for (int v = 0; done && v < surface->vertex_count; v++) {
    const bool low = is_on_plane(surface, up, v);
    for (long k = sides.starts[v]; k + 1 < sides.starts[v + 1]; k++) {
      const tp_side *own = sides.items + k;
      if (own[0].other != own[1].other || (low && is_on_plane(surface, up, own->other))) continue;
      tp_sides_join(leaders, own[0].triangle, own[1].triangle);
    }
  }
  tp_sides_clear(&sides);
  return done;
}

/* The sign of the volume of triangles of one leader; `room` has place for all. */
static int sign_of(const tp_surface *surface, int *leaders, int leader, int *room) {
  tp_surface own = *surface;
  tp_near near[TP_SOLID_SUM_COUNT];
  own.triangles = room;
  own.triangle_count = 0;
  for (int t = leader; t < surface->triangle_count; t++) {
    if (tp_sides_leader(leaders, t) != leader) continue;
    memcpy(room + 3 * own.triangle_count++, surface->triangles + 3L * t, 3 * sizeof *room);
  }
  tp_solid_sums_near(near, &own);
  if (tp_near_sign(near[TP_SOLID_V6]) != 0) return tp_near_sign(near[TP_SOLID_V6]);
  fmpz sums[TP_SOLID_SUM_COUNT], multiple;
  fmpz_init(&multiple);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init(sums + k);
  tp_solid_sums_exact(sums, &multiple, &own);
  const int sign = fmpz_sgn(sums + TP_SOLID_V6);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_clear(sums + k);
  fmpz_clear(&multiple);
  return sign;
}

static bool count_one(tp_cut_solids *solids, const tp_surface *surface, const fmpz *up, long number,
                      bool is_hole) {
  const size_t count = (size_t)surface->triangle_count;
  int *leaders = malloc((count + 1) * sizeof *leaders);
  int *room = malloc((3 * count + 1) * sizeof *room);
  bool done = leaders != NULL && room != NULL;
  for (int t = 0; done && t < (int)count; t++) leaders[t] = t;
  done = done && join(leaders, surface, up);
  for (int t = 0; done && t < (int)count; t++) {
    if (tp_sides_leader(leaders, t) != t) continue;
    if (sign_of(surface, leaders, t, room) != (is_hole ? -1 : 1)) continue;
    if (solids->count < 2) {
      solids->surfaces[solids->count] = number;
      solids->triangles[solids->count] = t;
    }
    solids->count++;
  }
  free(leaders);
  free(room);
  return done;
}

bool tp_cut_count(tp_cut_solids *solids, const tp_surface *surfaces, const bool *are_holes,
                  long count, const fmpz up[3]) {
  *solids = (tp_cut_solids){.count = 0};
  for (long k = 0; k < count; k++) {
    if (!count_one(solids, surfaces + k, up, k, are_holes[k])) return false;
  }
  return true;
}
