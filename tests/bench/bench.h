/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the benchmarks share: clocks, and arguments.
 *
 * Nothing here asserts a time: a benchmark fails only where a call fails, with exit status 5. */

#ifndef TP_BENCH_H
#define TP_BENCH_H

#include <gsl/gsl_statistics_double.h>
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

/* A whole number from `low` on in an argument; 0 where it is none. */
static inline long bench_count(const char *text, long low) {
  char *end = NULL;
  const long count = strtol(text, &end, 10);
  return *end == '\0' && count >= low ? count : 0;
}

#endif
