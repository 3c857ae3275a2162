/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Floor of value / 2^exponent + 1/2, by whole numbers. */

#include "number/grid.h"

void tp_round_to_grid(fmpq_t value, long exponent) {
  const unsigned long down = exponent > 0 ? (unsigned long)exponent : 0;
  const unsigned long up = exponent < 0 ? (unsigned long)-exponent : 0;
  fmpz_t doubled, whole;
  fmpz_init(doubled);
  fmpz_init(whole);
  fmpz_mul_2exp(whole, fmpq_numref(value), up + 1);
  fmpz_mul_2exp(doubled, fmpq_denref(value), down);
  fmpz_add(whole, whole, doubled);
  fmpz_mul_2exp(doubled, doubled, 1);
  fmpz_fdiv_q(whole, whole, doubled);
  fmpq_set_fmpz(value, whole);
  fmpq_div_2exp(value, value, up);
  fmpq_mul_2exp(value, value, down);
  fmpz_clear(doubled);
  fmpz_clear(whole);
}
