/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One formula of a tetrahedron in two arithmetics: doubles with bounds, added by halves, and whole
 * numbers. */

#include "solid/solid_sums.h"

enum { SOLID_REGISTERS = 11 };

/* ---- doubles with bounds -----------------------------------------------------------------------
 */

#define NUMBER tp_near
#define FUNCTION add_near
#define ADD(sum, a, b) (*(sum) = tp_near_add(*(a), *(b)))
#define SUBTRACT(difference, a, b) (*(difference) = tp_near_sub(*(a), *(b)))
#define MULTIPLY(product, a, b) (*(product) = tp_near_mul(*(a), *(b)))
#define ADD_PRODUCT(sum, a, b) (*(sum) = tp_near_add(*(sum), tp_near_mul(*(a), *(b))))
#include "solid/solid_sums_in.h"

/* Triangles that are added one after the other. */
enum { RUN = 32 };

static void add_run(tp_near *sums, const tp_surface *s, long from, long to) {
  tp_near r[SOLID_REGISTERS], at[3][3];
  const tp_near *const corners[3] = {at[0], at[1], at[2]};
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) sums[k] = (tp_near){0, 0};
  for (long t = from; t < to; t++) {
    for (int c = 0; c < 3; c++) {
      for (int k = 0; k < 3; k++) at[c][k] = tp_surface_near(s, s->triangles[3 * t + c], k);
    }
    add_near(sums, corners, r, TP_SOLID_SUM_COUNT);
  }
}

static void add_halves(tp_near *sums, const tp_surface *s, long from, long to) {
  if (to - from <= RUN) {
    add_run(sums, s, from, to);
    return;
  }
  const long middle = from + (to - from) / 2;
  tp_near other[TP_SOLID_SUM_COUNT];
  add_halves(sums, s, from, middle);
  add_halves(other, s, middle, to);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) sums[k] = tp_near_add(sums[k], other[k]);
}

void tp_solid_sums_near(tp_near sums[TP_SOLID_SUM_COUNT], const tp_surface *surface) {
  add_halves(sums, surface, 0, surface->triangle_count);
}

/* ---- whole numbers -----------------------------------------------------------------------------
 */

#define NUMBER fmpz
#define FUNCTION add_exact
#define ADD fmpz_add
#define SUBTRACT fmpz_sub
#define MULTIPLY fmpz_mul
#define ADD_PRODUCT fmpz_addmul
#include "solid/solid_sums_in.h"

void tp_solid_sums_exact(fmpz *sums, const tp_surface *surface, int sum_count) {
  fmpz r[SOLID_REGISTERS];
  for (int k = 0; k < SOLID_REGISTERS; k++) fmpz_init(r + k);
  for (int k = 0; k < sum_count; k++) fmpz_zero(sums + k);
  for (long t = 0; t < surface->triangle_count; t++) {
    const int *own = surface->triangles + 3 * t;
    const fmpz *const corners[3] = {surface->whole + 3L * own[0], surface->whole + 3L * own[1],
                                    surface->whole + 3L * own[2]};
    add_exact(sums, corners, r, sum_count);
  }
  for (int k = 0; k < SOLID_REGISTERS; k++) fmpz_clear(r + k);
}
