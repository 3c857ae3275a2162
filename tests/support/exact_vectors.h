/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points, turns and wrenches in rationals, for what tests compute by themselves. */

#ifndef TP_TEST_EXACT_VECTORS_H
#define TP_TEST_EXACT_VECTORS_H

#include <flint/fmpq.h>

typedef struct exact_point {
  fmpq x, y;
} exact_point;

static inline void exact_point_init(exact_point *p) {
  fmpq_init(&p->x);
  fmpq_init(&p->y);
}

static inline void exact_point_clear(exact_point *p) {
  fmpq_clear(&p->x);
  fmpq_clear(&p->y);
}

/* result = a b - c d; it is none of them */
static inline void exact_cross(fmpq_t result, const fmpq_t a, const fmpq_t b, const fmpq_t c,
                               const fmpq_t d) {
  fmpq_mul(result, a, b);
  fmpq_submul(result, c, d);
}

/* (x, y) turned counter-clockwise. */
static inline void exact_turn(exact_point *turned, const fmpq_t x, const fmpq_t y,
                              const fmpq_t cosine, const fmpq_t sine) {
  exact_cross(&turned->x, x, cosine, y, sine);
  fmpq_mul(&turned->y, x, sine);
  fmpq_addmul(&turned->y, y, cosine);
}

/* A force, and its moment about the origin. */
typedef struct exact_wrench {
  fmpq x, y, moment;
} exact_wrench;

static inline void exact_wrench_init(exact_wrench *w) {
  fmpq_init(&w->x);
  fmpq_init(&w->y);
  fmpq_init(&w->moment);
}

static inline void exact_wrench_clear(exact_wrench *w) {
  fmpq_clear(&w->x);
  fmpq_clear(&w->y);
  fmpq_clear(&w->moment);
}

static inline void exact_wrench_add(exact_wrench *w, const fmpq_t fx, const fmpq_t fy,
                                    const exact_point *at) {
  fmpq_add(&w->x, &w->x, fx);
  fmpq_add(&w->y, &w->y, fy);
  fmpq_addmul(&w->moment, &at->x, fy);
  fmpq_submul(&w->moment, &at->y, fx);
}

#endif
