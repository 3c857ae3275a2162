/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Noise on the heights of a profile: sums of twelve uniform numbers, which are nearly Gaussian with
 * unit standard deviation, times the deviation, rounded to ticks (docs/generate.md). */

#include "generate/generate.h"
#include "generate/random.h"
#include "generate/ticks.h"

#include <math.h>

/* Twelve even numbers within (-1/2, 1/2) have a standard deviation of 1 together. */
enum { PAIRS = 6 };

static double draw(uint64_t stream, long k) {
  double twice = 0;
  for (int pair = 0; pair < PAIRS; pair++) {
    const uint64_t bits = tp_random_bits(stream, (uint64_t)k * PAIRS + (uint64_t)pair);
    twice += tp_random_even((uint32_t)bits) + tp_random_even((uint32_t)(bits >> 32));
  }
  return twice / 2;
}

void tp_add_noise(tp_polyline *line, const fmpq_t deviation, uint64_t seed) {
  const uint64_t stream = tp_random_stream(seed, TP_STREAM_NOISE);
  tp_ticks ticks;
  fmpq_t zero, unit, moved;
  fmpq_init(zero);
  fmpq_init(unit);
  fmpq_init(moved);
  tp_ticks_millionth(unit, deviation);
  tp_ticks_init(&ticks, zero, unit);
  fmpq_div(unit, deviation, unit);
  const double scale = fmpq_get_d(unit);
  for (long k = 0; k < line->count; k++) {
    tp_ticks_at(moved, &ticks, (int64_t)floor(draw(stream, k) * scale + 0.5));
    fmpq_add(line->y + k, line->y + k, moved);
  }
  tp_ticks_clear(&ticks);
  fmpq_clear(zero);
  fmpq_clear(unit);
  fmpq_clear(moved);
}
