/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a sample of a study costs on one core, and each of its verdicts: the studies named, each
 * with the microseconds that a verdict is to take, at the scene's tilt and at the further ones that
 * it lists. Beside it the verdict of their scene as it stands, solved by itself. In microseconds of
 * computing time, medians of 5; with the share of samples told by doubles, and how many solves a
 * sample replaces for the time of one. To be read: a sample that doubles tell costs a tenth of a
 * solve or less (goal: under 10 us for a block of six vertices with both limits, drawing and
 * summing up included, and twice that under loads); further tilts share what does not depend on the
 * tilt. */

#include "bench_solve.h"

#include <string.h>

enum { ROUNDS = 5 };

static double alone(const char *path) {
  tp_scene *scene = NULL;
  expect(tp_scene_read(&scene, path, &message));
  return bench_solve(scene, ROUNDS);
}

static void measure(const char *path, const char *goal) {
  tp_study *study = NULL;
  tp_study_result *result = NULL;
  double times[ROUNDS];
  tp_study_options options = tp_study_options_default();
  options.threads = 1;
  expect(tp_study_read(&study, path, &message));
  for (int k = 0; k < ROUNDS; k++) {
    tp_study_result_free(result);
    const double began = bench_computed();
    expect(tp_study_run(&result, study, &options, &message));
    times[k] = 1e6 * (bench_computed() - began) / (double)result->samples;
  }
  const double sample = gsl_stats_median(times, 1, ROUNDS);
  const char *slash = strrchr(path, '/');
  const double verdict = sample / (double)result->tilt_count, solved = alone(result->scene);
  printf(
      "%-28s a sample at %2zu tilts %7.1f us, %3.0f %% by doubles, a verdict %6.1f us (goal %s), "
      "solved alone %6.1f us: %.1f times\n",
      slash != NULL ? slash + 1 : path, result->tilt_count, sample,
      100 * (double)result->by_doubles / (double)result->samples, verdict, goal, solved,
      solved / verdict);
  tp_study_result_free(result);
  tp_study_free(study);
}

int main(int argc, char **argv) {
  for (int k = 1; k + 1 < argc; k += 2) measure(argv[k], argv[k + 1]);
  return 0;
}
