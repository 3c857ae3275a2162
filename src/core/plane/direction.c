/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Direction reduced to coprime integers; integer square root of p^2 + q^2, exact or cut off at
 * TP_DIRECTION_BITS. */

#include "plane/direction.h"

void tp_direction_unit(fmpq_t cosine, fmpq_t sine, const fmpq_t u, const fmpq_t v) {
  fmpz_t p, q, square, root, rest;
  fmpz_init(p);
  fmpz_init(q);
  fmpz_init(square);
  fmpz_init(root);
  fmpz_init(rest);
  fmpz_mul(p, fmpq_numref(u), fmpq_denref(v));
  fmpz_mul(q, fmpq_numref(v), fmpq_denref(u));
  fmpz_gcd(rest, p, q);
  fmpz_divexact(p, p, rest);
  fmpz_divexact(q, q, rest);
  fmpz_mul(square, p, p);
  fmpz_addmul(square, q, q);
  fmpz_sqrtrem(root, rest, square);
  unsigned long cut = 0;
  if (!fmpz_is_zero(rest)) {
    cut = TP_DIRECTION_BITS;
    fmpz_mul_2exp(square, square, 2 * cut);
    fmpz_sqrt(root, square);
  }
  fmpq_set_fmpz_frac(cosine, p, root);
  fmpq_set_fmpz_frac(sine, q, root);
  fmpq_mul_2exp(cosine, cosine, cut);
  fmpq_mul_2exp(sine, sine, cut);
  fmpz_clear(p);
  fmpz_clear(q);
  fmpz_clear(square);
  fmpz_clear(root);
  fmpz_clear(rest);
}
