/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vectors of three whole numbers, of any size. */

#ifndef TP_GROUND_WHOLE_H
#define TP_GROUND_WHOLE_H

#include <flint/fmpq.h>
#include <stdbool.h>

typedef struct tp_whole {
  fmpz at[3];
} tp_whole;

static inline void tp_whole_init(tp_whole *v) {
  for (int k = 0; k < 3; k++) fmpz_init(v->at + k);
}

static inline void tp_whole_clear(tp_whole *v) {
  for (int k = 0; k < 3; k++) fmpz_clear(v->at + k);
}

static inline void tp_whole_sub(tp_whole *way, const fmpz *to, const fmpz *from) {
  for (int k = 0; k < 3; k++) fmpz_sub(way->at + k, to + k, from + k);
}

static inline void tp_whole_neg(tp_whole *v) {
  for (int k = 0; k < 3; k++) fmpz_neg(v->at + k, v->at + k);
}

static inline void tp_whole_dot(fmpz_t product, const tp_whole *a, const tp_whole *b) {
  fmpz_mul(product, a->at, b->at);
  fmpz_addmul(product, a->at + 1, b->at + 1);
  fmpz_addmul(product, a->at + 2, b->at + 2);
}

/* Not into one of both. */
static inline void tp_whole_cross(tp_whole *product, const tp_whole *a, const tp_whole *b) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(product->at + k, a->at + i, b->at + j);
    fmpz_submul(product->at + k, a->at + j, b->at + i);
  }
}

static inline bool tp_whole_is_zero(const tp_whole *v) {
  return fmpz_is_zero(v->at) && fmpz_is_zero(v->at + 1) && fmpz_is_zero(v->at + 2);
}

#endif
