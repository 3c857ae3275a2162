/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the quasi-static path costs: from level to the collapse, of each scene that is given,
 * towards the left, by the tolerance of its angles. Medians of 9 of the time computed, each run
 * repeated to last 5 ms. */

#include "bench.h"

#include "quasi_static/path.h"
#include "stability/problem.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

enum { SAMPLES = 9 };

static void fail(const char *what) {
  fprintf(stderr, "bench_path: %s\n", what);
  exit(BENCH_FAILED);
}

static void body_init(tp_rigid_body *body, const char *path) {
  tp_scene *scene = NULL;
  tp_problem problem;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  tp_solution *noted = calloc(1, sizeof *noted);
  if (noted == NULL) fail("out of memory");
  if (tp_scene_read(&scene, path, &message) != TP_OK ||
      tp_problem_init(&problem, scene, &options, noted, &message) != TP_OK ||
      tp_rigid_body_init(body, &problem, TP_TOWARDS_LEFT, &message) != TP_OK) {
    fail(message.text);
  }
  tp_problem_clear(&problem);
  tp_solution_free(noted);
  tp_scene_free(scene);
}

static tp_path_result run(const tp_rigid_body *body, const tp_path_settings *settings) {
  tp_path_result result;
  tp_message message;
  if (tp_path_run(&result, body, settings, NULL, &message) != TP_OK) fail(message.text);
  return result;
}

static void report(const tp_rigid_body *body, const char *path, double tolerance_deg) {
  const double degree = acos(-1) / 180;
  tp_path_settings settings = tp_path_settings_default();
  settings.tolerance = tolerance_deg * degree;
  settings.moments_every = 0;
  double seconds[SAMPLES];
  tp_path_result result = {0};
  for (int k = 0; k < SAMPLES; k++) {
    long runs = 0;
    const double began = bench_computed();
    for (; runs == 0 || bench_computed() - began < 5e-3; runs++) result = run(body, &settings);
    seconds[k] = (bench_computed() - began) / (double)runs;
  }
  gsl_sort(seconds, 1, SAMPLES);
  const char *name = strrchr(path, '/');
  printf("%-24s %7.0e degrees  %9.5f to %9.5f  %5ld balances  %7.1f us\n",
         name == NULL ? path : name + 1, tolerance_deg, result.stands_to / degree,
         result.collapses_at / degree, result.solves, 1e6 * seconds[SAMPLES / 2]);
}

int main(int count, char **paths) {
  for (int k = 1; k < count; k++) {
    tp_rigid_body body;
    body_init(&body, paths[k]);
    report(&body, paths[k], 0.05);
    report(&body, paths[k], 1e-6);
    tp_rigid_body_clear(&body);
  }
  return 0;
}
