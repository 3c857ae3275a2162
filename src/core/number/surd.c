/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With Q the common denominator, s = Q (c0 + sum c_k sqrt(d_k)) = C0 + sum C_k sqrt(d_k) is an
 * algebraic integer. Its conjugates are among the 2^n numbers with other signs of the roots, each
 * of at most M = |C0| + sum |C_k| (floor(sqrt(d_k)) + 1) in size. Where s is not zero the product
 * of its conjugates is a whole number other than zero, so that
 *
 *     |s| >= M^-(2^n - 1):
 *
 * a ball that lies within that of zero holds zero alone (Burnikel, Fleischer, Mehlhorn, Schirra,
 * Algorithmica 27 (2000) 87-99, for nested roots). Precision is doubled until the ball is on one
 * side of zero or within the bound; all but ties are settled by the first. */

#include "number/surd.h"

#include "number/ball.h"

#include <arb.h>
#include <stdbool.h>

void tp_surd_init(tp_surd *surd) {
  surd->count = 0;
  for (int k = 0; k <= TP_SURD_ROOTS; k++) fmpq_init(surd->c + k);
  for (int k = 0; k < TP_SURD_ROOTS; k++) fmpz_init(surd->d + k);
}

void tp_surd_clear(tp_surd *surd) {
  for (int k = 0; k <= TP_SURD_ROOTS; k++) fmpq_clear(surd->c + k);
  for (int k = 0; k < TP_SURD_ROOTS; k++) fmpz_clear(surd->d + k);
}

void tp_surd_add_root(tp_surd *surd, const fmpq_t factor, const fmpz_t radicand) {
  fmpz_set(surd->d + surd->count, radicand);
  fmpq_set(surd->c + ++surd->count, factor);
}

/* C_k, over the common denominator. */
static void set_whole(fmpz *whole, const tp_surd *s) {
  fmpz_t common;
  fmpz_init_set_ui(common, 1);
  for (long k = 0; k <= s->count; k++) fmpz_lcm(common, common, fmpq_denref(s->c + k));
  for (long k = 0; k <= s->count; k++) {
    fmpz_divexact(whole + k, common, fmpq_denref(s->c + k));
    fmpz_mul(whole + k, whole + k, fmpq_numref(s->c + k));
  }
  fmpz_clear(common);
}

/* Bits of M. */
static long bits_of_most(const fmpz *whole, const tp_surd *s) {
  fmpz_t most, part;
  fmpz_init(most);
  fmpz_init(part);
  fmpz_abs(most, whole);
  for (long k = 0; k < s->count; k++) {
    fmpz_sqrt(part, s->d + k);
    fmpz_add_ui(part, part, 1);
    fmpz_mul(part, part, whole + k + 1);
    fmpz_abs(part, part);
    fmpz_add(most, most, part);
  }
  const long bits = (long)fmpz_bits(most);
  fmpz_clear(most);
  fmpz_clear(part);
  return bits;
}

static void evaluate(arb_t value, const fmpz *whole, const tp_surd *s, long bits) {
  arb_t root;
  arb_init(root);
  arb_set_fmpz(value, whole);
  for (long k = 0; k < s->count; k++) {
    arb_sqrt_fmpz(root, s->d + k, bits);
    arb_addmul_fmpz(value, root, whole + k + 1, bits);
  }
  arb_clear(root);
}

int tp_surd_sign(const tp_surd *s) {
  enum { FIRST_BITS = 128 }; /* doubled until the sign is told; tells all but ties, as a rule */
  fmpz whole[TP_SURD_ROOTS + 1];
  for (int k = 0; k <= TP_SURD_ROOTS; k++) fmpz_init(whole + k);
  set_whole(whole, s);
  const long least = ((1L << s->count) - 1) * bits_of_most(whole, s); /* |s| >= 2^-least */
  arb_t value;
  arb_init(value);
  bool open = true;
  int sign = 0;
  for (long bits = FIRST_BITS; open; bits *= 2) {
    evaluate(value, whole, s, bits);
    sign = tp_ball_sign(value);
    mag_t size;
    mag_init(size);
    arb_get_mag(size, value);
    open = sign == 0 && mag_cmp_2exp_si(size, -least) >= 0;
    mag_clear(size);
  }
  arb_clear(value);
  for (int k = 0; k <= TP_SURD_ROOTS; k++) fmpz_clear(whole + k);
  return sign;
}
