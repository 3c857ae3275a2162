/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls of the library that must not fail, and what a solve of a scene costs. */

#ifndef TP_BENCH_SOLVE_H
#define TP_BENCH_SOLVE_H

#include "bench.h"

#include "topple.h"

static tp_message message;

static inline void expect(tp_status status) {
  if (status == TP_OK) return;
  fprintf(stderr, "%s\n", message.text);
  exit(BENCH_FAILED);
}

/* Microseconds of computing that a solve takes by one thread, the median of so many rounds, a
 * hundred solves each. The scene is given back. */
static inline double bench_solve(tp_scene *scene, int rounds) {
  enum { MOST = 15, SOLVES = 100 };
  double times[MOST];
  tp_solve_options options = tp_solve_options_default();
  options.pivots = TP_PIVOTS_GOVERNING;
  options.threads = 1;
  for (int k = 0; k < rounds && k < MOST; k++) {
    const double began = bench_computed();
    for (int i = 0; i < SOLVES; i++) {
      tp_solution *solution = NULL;
      expect(tp_solve(&solution, scene, &options, &message));
      tp_solution_free(solution);
    }
    times[k] = 1e6 * (bench_computed() - began) / SOLVES;
  }
  tp_scene_free(scene);
  return gsl_stats_median(times, 1, (size_t)(rounds < MOST ? rounds : MOST));
}

#endif
