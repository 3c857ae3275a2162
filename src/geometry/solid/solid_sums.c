/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One formula of a tetrahedron in two arithmetics: doubles with bounds, added by halves, and whole
 * numbers. */

#include "solid/solid_sums.h"

enum { SOLID_REGISTERS = 11 };

/* ---- doubles with bounds -----------------------------------------------------------------------
 */

#define COUNT TP_SOLID_SUM_COUNT
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
    add_near(sums, corners, r);
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

#define COUNT TP_SOLID_SUM_COUNT
#define NUMBER fmpz
#define FUNCTION add_exact
#define ADD fmpz_add
#define SUBTRACT fmpz_sub
#define MULTIPLY fmpz_mul
#define ADD_PRODUCT fmpz_addmul
#include "solid/solid_sums_in.h"

#define COUNT TP_SOLID_XX120
#define NUMBER fmpz
#define FUNCTION add_first
#define ADD fmpz_add
#define SUBTRACT fmpz_sub
#define MULTIPLY fmpz_mul
#define ADD_PRODUCT fmpz_addmul
#include "solid/solid_sums_in.h"

/* Sums times `multiple`. */
typedef struct exact_sums {
  fmpz sums[TP_SOLID_SUM_COUNT];
  fmpz_t multiple;
  fmpz r[SOLID_REGISTERS];
} exact_sums;

static void start_exact(exact_sums *own) {
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init(own->sums + k);
  for (int k = 0; k < SOLID_REGISTERS; k++) fmpz_init(own->r + k);
  fmpz_init_set_ui(own->multiple, 1);
}

static void end_exact(exact_sums *own) {
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_clear(own->sums + k);
  for (int k = 0; k < SOLID_REGISTERS; k++) fmpz_clear(own->r + k);
  fmpz_clear(own->multiple);
}

/* Both over their least common multiple. */
static void add_sums(exact_sums *own, exact_sums *other) {
  fmpz_t common, one, two;
  fmpz_init(common);
  fmpz_init(one);
  fmpz_init(two);
  fmpz_lcm(common, own->multiple, other->multiple);
  fmpz_divexact(one, common, own->multiple);
  fmpz_divexact(two, common, other->multiple);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) {
    fmpz_mul(own->sums + k, own->sums + k, one);
    fmpz_addmul(own->sums + k, other->sums + k, two);
  }
  fmpz_swap(own->multiple, common);
  fmpz_clear(common);
  fmpz_clear(one);
  fmpz_clear(two);
}

/* With corners over one denominator w, sums of n lengths are over w^n: 3 of the volume, 4 and 5. */
static void add_weighted(exact_sums *own, const tp_surface *s, const int *corners) {
  fmpz at[9], power;
  exact_sums one;
  start_exact(&one);
  fmpz_init(&power);
  for (int k = 0; k < 9; k++) fmpz_init(at + k);
  for (int c = 0; c < 3; c++) fmpz_lcm(one.multiple, one.multiple, s->weights + corners[c]);
  for (int k = 0; k < 9; k++) {
    fmpz_divexact(&power, one.multiple, s->weights + corners[k / 3]);
    fmpz_mul(at + k, s->whole + 3L * corners[k / 3] + k % 3, &power);
  }
  const fmpz *const points[3] = {at, at + 3, at + 6};
  add_exact(one.sums, points, one.r);
  for (int k = 0; k < TP_SOLID_XX120; k++) {
    fmpz_pow_ui(&power, one.multiple, k == TP_SOLID_V6 ? 2 : 1);
    fmpz_mul(one.sums + k, one.sums + k, &power);
  }
  fmpz_pow_ui(one.multiple, one.multiple, 5);
  add_sums(own, &one);
  for (int k = 0; k < 9; k++) fmpz_clear(at + k);
  fmpz_clear(&power);
  end_exact(&one);
}

static bool is_weighted(const tp_surface *s, const int *corners) {
  return s->weights != NULL &&
         !(fmpz_is_one(s->weights + corners[0]) && fmpz_is_one(s->weights + corners[1]) &&
           fmpz_is_one(s->weights + corners[2]));
}

/* Whole numbers one after the other; where there are weights by halves, as their multiple grows. */
static void add_exact_halves(exact_sums *own, const tp_surface *s, long from, long to) {
  if (to - from > RUN && s->weights != NULL) {
    const long middle = from + (to - from) / 2;
    exact_sums other;
    start_exact(&other);
    add_exact_halves(own, s, from, middle);
    add_exact_halves(&other, s, middle, to);
    add_sums(own, &other);
    end_exact(&other);
    return;
  }
  exact_sums whole;
  start_exact(&whole);
  for (long t = from; t < to; t++) {
    const int *corners = s->triangles + 3 * t;
    const fmpz *const points[3] = {s->whole + 3L * corners[0], s->whole + 3L * corners[1],
                                   s->whole + 3L * corners[2]};
    if (is_weighted(s, corners)) {
      add_weighted(own, s, corners);
    } else {
      add_exact(whole.sums, points, whole.r);
    }
  }
  add_sums(own, &whole);
  end_exact(&whole);
}

void tp_solid_sums_exact(fmpz *sums, fmpz_t multiple, const tp_surface *surface) {
  exact_sums own;
  start_exact(&own);
  add_exact_halves(&own, surface, 0, surface->triangle_count);
  for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_swap(sums + k, own.sums + k);
  fmpz_swap(multiple, own.multiple);
  end_exact(&own);
}

void tp_solid_first_sums_exact(fmpz *sums, const tp_surface *surface) {
  fmpz r[SOLID_REGISTERS];
  for (int k = 0; k < SOLID_REGISTERS; k++) fmpz_init(r + k);
  for (int k = 0; k < TP_SOLID_XX120; k++) fmpz_zero(sums + k);
  for (long t = 0; t < surface->triangle_count; t++) {
    const int *own = surface->triangles + 3 * t;
    const fmpz *const corners[3] = {surface->whole + 3L * own[0], surface->whole + 3L * own[1],
                                    surface->whole + 3L * own[2]};
    add_first(sums, corners, r);
  }
  for (int k = 0; k < SOLID_REGISTERS; k++) fmpz_clear(r + k);
}
