/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Coordinates by arithmetic in words of 60 bits, with common factors 2 and 5 removed first, or by
 * rationals beyond that. */

#include "generate/ticks.h"

#include "number/word.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* Of the parts, and of m each: the sum stays below 2^62. */
enum { BITS = 60 };

void tp_ticks_init(tp_ticks *ticks, const fmpq_t origin, const fmpq_t unit) {
  fmpz_t below, part;
  fmpq_init(ticks->origin);
  fmpq_init(ticks->unit);
  fmpq_set(ticks->origin, origin);
  fmpq_set(ticks->unit, unit);
  ticks->first = ticks->each = ticks->below = 0;
  ticks->twos = 0;
  ticks->most = 0;
  ticks->other = 1;
  fmpz_init(below);
  fmpz_init(part);
  fmpz_lcm(below, fmpq_denref(origin), fmpq_denref(unit));
  if (fmpz_bits(below) <= BITS) {
    fmpz_divexact(part, below, fmpq_denref(origin));
    fmpz_mul(part, part, fmpq_numref(origin));
    const bool fits = fmpz_bits(part) <= BITS;
    if (fits) ticks->first = tp_word_get(part);
    fmpz_divexact(part, below, fmpq_denref(unit));
    fmpz_mul(part, part, fmpq_numref(unit));
    if (fits && fmpz_bits(part) <= BITS) {
      ticks->each = tp_word_get(part);
      ticks->most = (INT64_C(1) << BITS) / llabs(ticks->each);
      ticks->below = tp_word_get(below);
      ticks->twos = __builtin_ctzll((unsigned long long)ticks->below);
      ticks->other = ticks->below >> ticks->twos;
      while (ticks->other % 5 == 0) ticks->other /= 5;
    }
  }
  fmpz_clear(below);
  fmpz_clear(part);
}

void tp_ticks_clear(tp_ticks *ticks) {
  fmpq_clear(ticks->origin);
  fmpq_clear(ticks->unit);
}

/* The greatest common divisor by Euclid; most ends come at once, as decimals share small factors.
 */
static int64_t common(int64_t a, int64_t b) {
  while (b != 0) {
    const int64_t rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

/* In lowest terms: by 2 and by 5, which are the factors of decimals, and by what else there is. */
static void set_words(fmpq_t value, const tp_ticks *ticks, int64_t above) {
  int64_t size = llabs(above), below = ticks->below;
  if (size == 0) {
    fmpq_zero(value);
    return;
  }
  const int own = __builtin_ctzll((unsigned long long)size);
  const int twos = own < ticks->twos ? own : ticks->twos;
  size >>= twos;
  below >>= twos;
  while (size % 5 == 0 && below % 5 == 0) {
    below /= 5;
    size /= 5;
  }
  if (ticks->other > 1) {
    const int64_t shared = common(ticks->other, size);
    size /= shared;
    below /= shared;
  }
  tp_word_set(fmpq_numref(value), above < 0 ? -size : size);
  tp_word_set(fmpq_denref(value), below);
}

void tp_ticks_at(fmpq_t value, const tp_ticks *ticks, int64_t m) {
  if (ticks->below != 0 && llabs(m) <= ticks->most) {
    set_words(value, ticks, ticks->first + m * ticks->each);
  } else {
    fmpz_t steps;
    fmpz_init(steps);
    tp_word_set(steps, m);
    fmpq_mul_fmpz(value, ticks->unit, steps);
    fmpz_clear(steps);
    fmpq_add(value, value, ticks->origin);
  }
}

static void set_power(fmpq_t power, long exponent) {
  fmpq_zero(power);
  fmpz_set_si(fmpq_numref(power), 10);
  fmpz_pow_ui(fmpq_numref(power), fmpq_numref(power), (ulong)labs(exponent));
  if (exponent < 0) fmpq_inv(power, power);
}

/* The exponent is guessed from a double and made right by comparisons. */
void tp_ticks_millionth(fmpq_t unit, const fmpq_t size) {
  fmpq_t most, ten;
  fmpq_init(most);
  fmpq_init(ten);
  fmpq_set_si(most, 1000000, 1);
  fmpq_div(most, size, most);
  fmpq_set_si(ten, 10, 1);
  set_power(unit, (long)floor(log10(fmpq_get_d(size))) - 5);
  while (fmpq_cmp(unit, most) > 0) fmpq_div(unit, unit, ten);
  for (;;) {
    fmpq_mul(ten, unit, ten);
    if (fmpq_cmp(ten, most) > 0) break;
    fmpq_set(unit, ten);
    fmpq_set_si(ten, 10, 1);
  }
  fmpq_clear(most);
  fmpq_clear(ten);
}

void tp_ticks_round(fmpq_t value, const fmpq_t unit) {
  fmpz_t twice;
  fmpq_div(value, value, unit);
  fmpz_init(twice);
  fmpz_mul_2exp(twice, fmpq_denref(value), 1);
  fmpz_mul_2exp(fmpq_numref(value), fmpq_numref(value), 1);
  fmpz_add(fmpq_numref(value), fmpq_numref(value), fmpq_denref(value));
  fmpz_fdiv_q(fmpq_numref(value), fmpq_numref(value), twice);
  fmpz_one(fmpq_denref(value));
  fmpz_clear(twice);
  fmpq_mul(value, value, unit);
}
