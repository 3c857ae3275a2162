/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whole numbers of FLINT as words of 64 bits, whatever FLINT's own words have: where they have 32,
 * as on machines with a `long` of 32 bits, a number of 40 bits is a large one to FLINT. The same
 * paths are taken with either, so that doubles come out the same. */

#ifndef TP_NUMBER_WORD_H
#define TP_NUMBER_WORD_H

#include <flint/fmpq.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum {
  TP_WORD_SMALL_BITS = 62, /* of the numbers that FLINT keeps within one word of 64 bits */
  TP_WORD_LIMBS = 64 / FLINT_BITS
};

/* Of 62 bits at most? */
static inline bool tp_word_is_small(const fmpz *number) {
#if FLINT_BITS == 64
  return !COEFF_IS_MPZ(*number);
#else
  return fmpz_bits(number) <= TP_WORD_SMALL_BITS;
#endif
}

/* Does an int64_t hold it? */
static inline bool tp_word_fits(const fmpz *number) {
#if FLINT_BITS == 64
  return fmpz_fits_si(number) != 0;
#else
  return fmpz_bits(number) < 64 ||
         (fmpz_bits(number) == 64 && fmpz_sgn(number) < 0 && fmpz_val2(number) == 63);
#endif
}

/* Of a number that an int64_t holds. */
static inline int64_t tp_word_get(const fmpz *number) {
#if FLINT_BITS == 64
  return fmpz_get_si(number);
#else
  ulong high, low;
  fmpz_get_signed_uiui(&high, &low, number);
  return (int64_t)((uint64_t)high << 32 | low);
#endif
}

/* The number where it is small, else false: without a call. */
static inline bool tp_word_small(int64_t *word, const fmpz *number) {
#if FLINT_BITS == 64
  *word = *number;
  return !COEFF_IS_MPZ(*number);
#else
  if (!tp_word_is_small(number)) return false;
  *word = tp_word_get(number);
  return true;
#endif
}

static inline void tp_word_set_unsigned(fmpz *number, uint64_t word) {
#if FLINT_BITS == 64
  fmpz_set_ui(number, word);
#else
  fmpz_set_uiui(number, (ulong)(word >> 32), (ulong)word);
#endif
}

static inline void tp_word_set(fmpz *number, int64_t word) {
#if FLINT_BITS == 64
  fmpz_set_si(number, word);
#else
  fmpz_set_uiui(number, (ulong)((word < 0 ? 0 - (uint64_t)word : (uint64_t)word) >> 32),
                (ulong)(word < 0 ? 0 - (uint64_t)word : (uint64_t)word));
  if (word < 0) fmpz_neg(number, number);
#endif
}

/* The greatest common divisor, of small numbers: a few steps, without a call. */
static inline int64_t tp_word_gcd(int64_t a, int64_t b) {
  while (b != 0) {
    const int64_t rest = a % b;
    a = b;
    b = rest;
  }
  return a < 0 ? -a : a;
}

/* The top 64 bits of a mantissa of one limb or more, the first of which is set; what else there is
 * lies in limbs beyond TP_WORD_LIMBS. */
static inline uint64_t tp_word_top(mp_srcptr limbs, mp_size_t count) {
#if FLINT_BITS == 64
  return limbs[count - 1];
#else
  return (uint64_t)limbs[count - 1] << 32 | (count > 1 ? limbs[count - 2] : 0);
#endif
}

/* As fmpq_cmp, by products of two words where all numbers are small. */
static inline int tp_word_order(const fmpq *a, const fmpq *b) {
  int64_t p, q, r, s;
  if (!tp_word_small(&p, fmpq_numref(a)) || !tp_word_small(&q, fmpq_denref(a)) ||
      !tp_word_small(&r, fmpq_numref(b)) || !tp_word_small(&s, fmpq_denref(b))) {
    return fmpq_cmp(a, b);
  }
  const __int128 one = (__int128)p * s, other = (__int128)r * q;
  return (one > other) - (one < other);
}

/* Of two whole numbers. */
static inline bool tp_word_equal(const fmpz *a, const fmpz *b) {
  int64_t one, other;
  const bool known = tp_word_small(&one, a), other_known = tp_word_small(&other, b);
  return known && other_known ? one == other : fmpz_equal(a, b) != 0;
}

/* to - from, off by 3 u of its size at most, of fractions whose parts have 31 bits, as decimals of
 * a few digits are; false for others. */
static inline bool tp_word_difference(double *difference, const fmpq *to, const fmpq *from) {
  const int64_t whole = INT64_C(1) << 31;
  if (!tp_word_is_small(fmpq_numref(to)) || !tp_word_is_small(fmpq_denref(to)) ||
      !tp_word_is_small(fmpq_numref(from)) || !tp_word_is_small(fmpq_denref(from))) {
    return false;
  }
  const int64_t a = tp_word_get(fmpq_numref(to)), b = tp_word_get(fmpq_denref(to));
  const int64_t c = tp_word_get(fmpq_numref(from)), d = tp_word_get(fmpq_denref(from));
  if (llabs(a) >= whole || b >= whole || llabs(c) >= whole || d >= whole) return false;
  *difference = (double)(a * d - c * b) / (double)(b * d);
  return true;
}

#endif
