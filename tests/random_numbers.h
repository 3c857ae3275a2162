/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random numbers that are the same on every machine: splitmix64. */

#ifndef TP_TEST_RANDOM_NUMBERS_H
#define TP_TEST_RANDOM_NUMBERS_H

#include <stdint.h>

static inline uint64_t draw(uint64_t *state) {
  uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/* From 0 to count - 1. */
static inline long draw_below(uint64_t *state, long count) {
  return (long)(draw(state) % (uint64_t)count);
}

#endif
