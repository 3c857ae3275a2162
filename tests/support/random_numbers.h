/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random numbers that are the same on every machine: the maximally equidistributed Tausworthe
 * generator of L'Ecuyer (1999), gsl_rng_taus2 of the GNU Scientific Library, which starts quickly.
 * GSL keeps its state where it is told to: here in a value, which needs no freeing. */

#ifndef TP_TEST_RANDOM_NUMBERS_H
#define TP_TEST_RANDOM_NUMBERS_H

#include <gsl/gsl_rng.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct random_numbers {
  unsigned long words[8];
} random_numbers;

static inline gsl_rng random_generator(random_numbers *numbers) {
  if (gsl_rng_taus2->size > sizeof numbers->words) abort();
  return (gsl_rng){gsl_rng_taus2, numbers->words};
}

/* The generator tells 2^32 seeds apart; longer ones are folded. */
static inline random_numbers random_numbers_from(uint64_t seed) {
  random_numbers numbers;
  gsl_rng generator = random_generator(&numbers);
  gsl_rng_set(&generator, (unsigned long)((seed ^ seed >> 32) & UINT32_MAX));
  return numbers;
}

/* 64 bits. */
static inline uint64_t draw(random_numbers *numbers) {
  const gsl_rng generator = random_generator(numbers);
  const uint64_t high = gsl_rng_get(&generator);
  return high << 32 | gsl_rng_get(&generator);
}

/* From 0 to count - 1. */
static inline long draw_below(random_numbers *numbers, long count) {
  return (long)(draw(numbers) % (uint64_t)count);
}

/* From 0 to below 1, of as many bits as a double holds. */
static inline double draw_part(random_numbers *numbers) {
  return (double)(draw(numbers) >> 11) * 0x1p-53;
}

#endif
