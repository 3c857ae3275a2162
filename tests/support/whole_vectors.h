/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vectors of three whole numbers, and contacts set in such. */

#ifndef TP_TEST_WHOLE_VECTORS_H
#define TP_TEST_WHOLE_VECTORS_H

#include "linear_program/cones.h"
#include "plane/vector.h"

#include <check.h>
#include <stdbool.h>

typedef struct whole {
  long of[3];
} whole;

static inline long dot(const whole *a, const whole *b) {
  return a->of[0] * b->of[0] + a->of[1] * b->of[1] + a->of[2] * b->of[2];
}

static inline whole cross(const whole *a, const whole *b) {
  return (whole){{a->of[1] * b->of[2] - a->of[2] * b->of[1],
                  a->of[2] * b->of[0] - a->of[0] * b->of[2],
                  a->of[0] * b->of[1] - a->of[1] * b->of[0]}};
}

static inline bool is_zero(const whole *a) {
  return a->of[0] == 0 && a->of[1] == 0 && a->of[2] == 0;
}

static inline bool are_along(const whole *a, const whole *b) {
  const whole across = cross(a, b);
  return is_zero(&across) && dot(a, b) > 0;
}

static inline long whole_of(const arb_t ball) {
  ck_assert(arb_is_int(ball));
  return arf_get_si(arb_midref(ball), ARF_RND_DOWN);
}

static inline whole whole_vector(const tp_vector *v) {
  return (whole){{whole_of(v->of), whole_of(v->of + 1), whole_of(v->of + 2)}};
}

static inline void set_point(tp_cones *cones, long k, long x, long y, long tx, long ty) {
  arb_t at[2];
  for (int e = 0; e < 2; e++) arb_init(at[e]);
  arb_set_si(at[0], x);
  arb_set_si(at[1], y);
  tp_cones_set_place(cones, k, at[0], at[1]);
  for (int e = 0; e < 2; e++) arb_clear(at[e]);
  fmpz_set_si(cones->tx + k, tx);
  fmpz_set_si(cones->ty + k, ty);
  cones->points[k] = (tp_cone_point){.site = (int32_t)k, .facet = (int32_t)k};
}

#endif
