/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A check of triangles that CGAL found: all are counter-clockwise, and their areas add up to that
 * of the outline less those of the holes, in whole numbers. That is necessary, and no proof: a
 * corner in place of another one at the same distance from its side would pass. */

#include "block/check.h"

/* Adds twice the area of a triangle of lattice points; is it counter-clockwise? */
static bool add_triangle(fmpz_t sum, fmpz work[3], const tp_lattice *l, const size_t corner[3]) {
  const fmpz *x = l->x, *y = l->y;
  fmpz_sub(work, x + corner[1], x + corner[0]);
  fmpz_sub(work + 1, y + corner[2], y + corner[0]);
  fmpz_mul(work + 2, work, work + 1);
  fmpz_sub(work, y + corner[1], y + corner[0]);
  fmpz_sub(work + 1, x + corner[2], x + corner[0]);
  fmpz_submul(work + 2, work, work + 1);
  fmpz_add(sum, sum, work + 2);
  return fmpz_sgn(work + 2) > 0;
}

bool tp_check_fills(const tp_geom_triangulation *t, const tp_lattice *lattice, long hole_count) {
  fmpz_t sum, ring;
  fmpz work[3];
  bool fills = true;
  fmpz_init(sum);
  fmpz_init(ring);
  for (int k = 0; k < 3; k++) fmpz_init(work + k);
  for (size_t k = 0; k < t->count && fills; k++) {
    fills = add_triangle(sum, work, lattice, t->triangles[k].corner);
  }
  for (long r = 0; r <= hole_count; r++) {
    const size_t first = (size_t)lattice->start[r], end = (size_t)lattice->start[r + 1];
    fmpz_zero(ring);
    for (size_t k = first + 1; k + 1 < end; k++) {
      (void)add_triangle(ring, work, lattice, (const size_t[]){first, k, k + 1});
    }
    fmpz_abs(ring, ring);
    if (r == 0) fmpz_neg(ring, ring);
    fmpz_add(sum, sum, ring);
  }
  fills = fills && fmpz_is_zero(sum);
  fmpz_clear(sum);
  fmpz_clear(ring);
  for (int k = 0; k < 3; k++) fmpz_clear(work + k);
  return fills;
}
