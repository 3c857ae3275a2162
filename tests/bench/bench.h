/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the benchmarks share: a clock, the median, a rough outline made from a fixed seed.
 *
 * Nothing here asserts a time: a benchmark fails only where a call fails, with exit status 5. */

#ifndef TP_BENCH_H
#define TP_BENCH_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { BENCH_FAILED = 5 };

/* Seconds of a clock that never goes back. */
static inline double bench_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Seconds that this thread has computed; other programs on the machine disturb it less. */
static inline double bench_computed(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline int bench_compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The median; sorts the samples. */
static inline double bench_median(double *samples, size_t count) {
  qsort(samples, count, sizeof *samples, bench_compare);
  return (samples[(count - 1) / 2] + samples[count / 2]) / 2;
}

/* A whole number from `low` on in an argument; 0 where it is none. */
static inline long bench_count(const char *text, long low) {
  char *end = NULL;
  const long count = strtol(text, &end, 10);
  return *end == '\0' && count >= low ? count : 0;
}

/* The next of a fixed sequence of numbers from 0 to `below` - 1 (Knuth's linear congruence). */
static inline long bench_random(uint64_t *state, long below) {
  *state = *state * 6364136223846793005U + 1442695040888963407U;
  return (long)(*state >> 33) % below;
}

/* An outline of `count` >= 4 vertices in units of 0.1 um, counter-clockwise: a rough underside from
 * left to right in steps of about 0.01 mm, its slopes about half, closed over the top. */
static inline void bench_outline(double *x, double *y, long count) {
  uint64_t state = 2026;
  const long foot = count - 2;
  long along = 0, height = 0;
  for (long k = 0; k < foot; k++) {
    x[k] = (double)along;
    y[k] = k + 1 == foot ? 0 : (double)height;
    along += 60 + bench_random(&state, 81);
    height += bench_random(&state, 101) - 50 - height / 64;
  }
  x[foot] = x[foot - 1];
  x[foot + 1] = x[0];
  y[foot] = y[foot + 1] = 4096 + (double)(along / 5 * 2);
}

#endif
