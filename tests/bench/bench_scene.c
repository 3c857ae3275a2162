/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block of six vertices in arrays, to a certified verdict: building the scene, solving it, and
 * reading the same scene from text instead, in microseconds of computing time, the median of many
 * runs. All of it is to the verdict of one direction of tilt. */

#include "bench_solve.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

enum { RUNS = 2000 };

static const double outline[] = {0, 0, 30, 5, 60, 0, 90, 5, 90, 125, 0, 120};
static const char text[] = "topple: 1\nlength_unit: mm\nblock:\n  outline: [[0, 0], [30, 5], "
                           "[60, 0], [90, 5], [90, 125], [0, 120]]\nfriction_angle_deg: 30\n"
                           "tilt: {towards: left, angle_deg: 20}\n";

static tp_scene *build(void) {
  tp_scene *scene = NULL;
  expect(tp_scene_new(&scene, "mm", &message));
  expect(tp_scene_set_outline(scene, tp_coordinates_of(outline, 6), &message));
  expect(tp_scene_set_friction_angle_deg(scene, tp_exact_of(30), &message));
  expect(tp_scene_set_tilt_towards(scene, true, false, &message));
  expect(tp_scene_set_tilt_angle_deg(scene, tp_exact_of(20), &message));
  return scene;
}

static tp_scene *read_text(void) {
  tp_scene *scene = NULL;
  expect(tp_scene_read_text(&scene, text, "bench", &message));
  return scene;
}

static void measure(const char *what, tp_scene *(*make)(void), const tp_solve_options *options) {
  static double makes[RUNS], solves[RUNS], both[RUNS];
  for (int k = 0; k < RUNS; k++) {
    tp_solution *solution = NULL;
    const double began = bench_computed();
    tp_scene *scene = make();
    const double made = bench_computed();
    if (options != NULL) expect(tp_solve(&solution, scene, options, &message));
    const double solved = bench_computed();
    tp_solution_free(solution);
    tp_scene_free(scene);
    makes[k] = 1e6 * (made - began);
    solves[k] = 1e6 * (solved - made);
    both[k] = 1e6 * (solved - began);
  }
  gsl_sort(makes, 1, RUNS);
  gsl_sort(solves, 1, RUNS);
  gsl_sort(both, 1, RUNS);
  printf("%-40s scene %7.1f us, solve %7.1f us, together %7.1f us\n", what,
         gsl_stats_median_from_sorted_data(makes, 1, RUNS),
         gsl_stats_median_from_sorted_data(solves, 1, RUNS),
         gsl_stats_median_from_sorted_data(both, 1, RUNS));
}

int main(void) {
  tp_solve_options all = tp_solve_options_default(), toppling = all, limit = all;
  toppling.limit = toppling.strength_reduction = false;
  limit.strength_reduction = false;
  measure("from arrays, all", build, &all);
  measure("from arrays, without strength reduction", build, &limit);
  measure("from arrays, toppling and sliding", build, &toppling);
  measure("from text, all", read_text, &all);
  return 0;
}
