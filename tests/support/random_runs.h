/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many random scenes a test draws, and from which seed.
 *
 * Scene k is drawn from the state seed + k alone, so that a scene which fails is the first one of
 * the seed that its message names:
 *     TOPPLE_RANDOM_SEED=… TOPPLE_RANDOM_SCENES=1 build/tests/test_random_…  */

#ifndef TP_TEST_RANDOM_RUNS_H
#define TP_TEST_RANDOM_RUNS_H

#include "random_numbers.h"
#include "rounds.h"

#include <stdlib.h>

static inline uint64_t number_from_environment(const char *name, uint64_t otherwise) {
  const char *text = getenv(name);
  return text != NULL ? strtoull(text, NULL, 10) : otherwise;
}

static inline uint64_t random_seed(void) {
  return number_from_environment("TOPPLE_RANDOM_SEED", UINT64_C(20260101) << 32);
}

/* Scenes to solve, where the environment does not say: so many, and under ./check --long. */
static inline long random_scenes_of(long brief, long many) {
  return (long)number_from_environment("TOPPLE_RANDOM_SCENES", (uint64_t)rounds(brief, many));
}

/* Ten times as many under ./check --long; the test of sums draws a thousand polygons for each. */
static inline long random_scenes_or(long otherwise) {
  return random_scenes_of(otherwise, 10 * otherwise);
}

static inline long random_scenes(void) {
  return random_scenes_or(1000);
}

/* True once in `count` times. */
static inline int draw_once_in(random_numbers *state, long count) {
  return draw_below(state, count) == 0;
}

/* From -size to size. */
static inline long draw_signed(random_numbers *state, long size) {
  return draw_below(state, 2 * size + 1) - size;
}

#endif
