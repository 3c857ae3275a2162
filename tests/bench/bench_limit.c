/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the static limit and the onset of motion cost: on block E (argument 1), on a rough mated
 * base of 10^5 facets, and on a bowl of as many, half of which bound the twists.
 *
 * Measured on each, medians of 9, a short sample repeated to last 5 ms: the simplex method in
 * doubles on prepared columns; the certified limit, its doubles prepared anew, found and proven at
 * 64 bits; the exact program by CGAL, to compare with, from the same columns with tan(phi) rounded
 * to 64 bits; the limit with the cones that it is asked of, and the onset with its own, all windows
 * of it, each found and proven at 64 bits; and the whole of tp_solve, of a scene that is read.
 * `ratio` is over the doubles. */

#include "bench.h"

#include "accuracy/rough_outline.h"

#include "block/moments.h"
#include "limit/limit.h"
#include "limit/search.h"
#include "linear_program/basis.h"
#include "motion/windows.h"
#include "number/ball.h"
#include "onset/onset_question.h"
#include "static_limit/limit_cones.h"

#include <string.h>
#include <unistd.h>

enum { SAMPLES = 9, VERTICES = 100002, BITS = 64 };

static void fail(const char *what) {
  fprintf(stderr, "bench_limit: %s\n", what);
  exit(BENCH_FAILED);
}

typedef struct work {
  tp_scene *scene;
  tp_problem problem;
  tp_solution *noted; /* what the preparation notes */
  tp_evaluation evaluation;
  tp_cones cones;
  tp_wrench load;
  tp_limit_question question;
  tp_scaled scaled;
  tp_vector direction, target;
  double scaled_ends[2][3];
} work;

static volatile double sink; /* what the compiler must not leave out */

static void solve_in_double(work *w) {
  sink = tp_scaled_solve(&w->scaled, w->scaled_ends[0], w->scaled_ends[1]).t;
}

static void find_certified(work *w) {
  tp_limit_answer answer;
  if (!tp_limit_answer_init(&answer, &w->cones)) fail("out of memory");
  if (tp_limit_find(&answer, &w->question) != TP_LIMIT_PROVEN) fail("the limit is not proven");
  sink = arf_get_d(arb_midref(answer.degrees), ARF_RND_NEAR);
  tp_limit_answer_clear(&answer);
}

static void solve_exactly(work *w) {
  const long count = tp_cones_column_count(&w->cones);
  long *all = malloc((size_t)count * sizeof *all);
  if (all == NULL) fail("out of memory");
  for (long k = 0; k < count; k++) all[k] = k;
  tp_basis basis;
  if (tp_basis_exact(&basis, &w->cones, all, count, &w->direction, &w->target, BITS) != TP_OK) {
    fail("CGAL fails");
  }
  sink = (double)basis.columns[0];
  free(all);
}

static void find_limit(work *w) {
  const tp_cones kept = w->cones;
  if (!tp_limit_cones_init(&w->cones, &w->evaluation, TP_TOWARDS_LEFT, false)) {
    fail("out of memory");
  }
  arb_set(w->cones.friction, kept.friction);
  find_certified(w);
  tp_cones_clear(&w->cones);
  w->cones = kept;
}

static void find_onset(work *w) {
  tp_onset_asked asked;
  tp_motions motions;
  tp_motion_windows windows;
  if (!tp_onset_asked_init(&asked, &w->evaluation, TP_TOWARDS_LEFT, NULL)) fail("out of memory");
  arb_set(asked.cones.friction, w->cones.friction);
  asked.question.judge = w->question.judge;
  if (tp_motions_init(&motions, &asked.question) != TP_MOTION_PROVEN ||
      tp_windows_init(&windows, &motions, &asked.question.judge) != TP_MOTION_PROVEN) {
    fail("the onset is not proven");
  }
  sink = (double)windows.count;
  tp_windows_clear(&windows);
  tp_motions_clear(&motions);
  tp_onset_asked_clear(&asked);
}

static void solve_whole(work *w) {
  const tp_solve_options options = tp_solve_options_default();
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  if (tp_solve(&solution, w->scene, &options, &message) != TP_OK) fail(message.text);
  sink = solution->cases[0].limit.critical_angle_deg.value;
  tp_solution_free(solution);
}

typedef struct row {
  const char *name;
  void (*run)(work *w);
} row;

static const row rows[] = {{"doubles", solve_in_double},      {"certified", find_certified},
                           {"exact, CGAL", solve_exactly},    {"limit, with cones", find_limit},
                           {"onset, with cones", find_onset}, {"whole tp_solve", solve_whole}};
enum { ROWS = sizeof rows / sizeof rows[0] };

static double seconds_of(const row *r, work *w, long repeats) {
  const double began = bench_now();
  for (long k = 0; k < repeats; k++) r->run(w);
  return (bench_now() - began) / (double)repeats;
}

/* The weight alone, in lattice units, towards the left. */
static void set_load(work *w) {
  const arb_struct *sums = w->evaluation.moments.weighted;
  tp_wrench_init(&w->load);
  arb_mul_si(w->load.x.of + TP_SIN, sums + TP_A2, -3, BITS);
  arb_set(w->load.y.of + TP_COS, w->load.x.of + TP_SIN);
  arb_neg(w->load.moment.of + TP_COS, sums + TP_X6);
  arb_set(w->load.moment.of + TP_SIN, sums + TP_Y6);
}

static void set_friction(work *w) {
  arb_t cosine;
  arb_init(cosine);
  tp_ball_sin_cos_degrees(w->cones.friction, cosine, w->scene->friction_angle_deg.value, BITS);
  arb_div(w->cones.friction, w->cones.friction, cosine, BITS);
  arb_clear(cosine);
}

static void work_init(work *w, const char *path) {
  const tp_solve_options options = tp_solve_options_default();
  tp_message message = {.text = ""};
  memset(w, 0, sizeof *w);
  w->noted = calloc(1, sizeof *w->noted);
  if (w->noted == NULL) fail("out of memory");
  if (tp_scene_read(&w->scene, path, &message) != TP_OK) fail(message.text);
  if (tp_problem_init(&w->problem, w->scene, &options, w->noted, &message) != TP_OK) {
    fail(message.text);
  }
  w->evaluation = (tp_evaluation){.problem = &w->problem, .rung = {TP_LEVEL_DOUBLE, BITS}};
  tp_moments_init(&w->evaluation.moments);
  tp_moments_evaluate(&w->evaluation.moments, &w->problem.section, &w->problem.lattice,
                      w->scene->metres_per_unit, w->evaluation.rung, TP_SUM_COUNT);
  if (!tp_limit_cones_init(&w->cones, &w->evaluation, TP_TOWARDS_LEFT, false)) {
    fail("out of memory");
  }
  set_friction(w);
  set_load(w);
  w->question = (tp_limit_question){
      .cones = &w->cones, .load = &w->load, .judge = {.bits = BITS, .precision = BITS}};
  tp_vector_init(&w->direction);
  tp_vector_init(&w->target);
  tp_question_load_term(&w->direction, &w->load, TP_SIN);
  tp_question_load_term(&w->target, &w->load, TP_COS);
  if (!tp_scaled_init(&w->scaled, &w->cones, &w->target, BITS)) fail("out of memory");
  tp_vector_neg(&w->target);
  tp_scaled_wrench(w->scaled_ends[0], &w->scaled, &w->direction);
  tp_scaled_wrench(w->scaled_ends[1], &w->scaled, &w->target);
}

static void work_clear(work *w) {
  tp_scaled_clear(&w->scaled);
  tp_vector_clear(&w->direction);
  tp_vector_clear(&w->target);
  tp_wrench_clear(&w->load);
  tp_cones_clear(&w->cones);
  tp_moments_clear(&w->evaluation.moments);
  tp_problem_clear(&w->problem);
  tp_solution_free(w->noted);
  tp_scene_free(w->scene);
}

static void measure(const char *name, const char *path) {
  work w;
  double samples[ROWS][SAMPLES], medians[ROWS];
  long repeats[ROWS];
  work_init(&w, path);
  for (int r = 0; r < ROWS; r++) {
    repeats[r] = 1;
    while (seconds_of(rows + r, &w, repeats[r]) * (double)repeats[r] < 5e-3) repeats[r] *= 2;
  }
  for (int s = 0; s < SAMPLES; s++) {
    for (int r = 0; r < ROWS; r++) samples[r][s] = seconds_of(rows + r, &w, repeats[r]);
  }
  printf("%s: %ld facets\n", name, w.problem.contact.facet_count);
  for (int r = 0; r < ROWS; r++) {
    medians[r] = gsl_stats_median(samples[r], 1, SAMPLES);
    printf("  %-18s %12.1f us %10.1f\n", rows[r].name, 1e6 * medians[r], medians[r] / medians[0]);
  }
  work_clear(&w);
}

/* An arc of a parabola below a block as high as it is wide. */
static void bowl(double *x, double *y, long count) {
  const long facets = count - 3;
  for (long k = 0; k <= facets; k++) {
    const double across = (double)(2 * k - facets);
    x[k] = across * 1e4;
    y[k] = across * across / (double)(2 * facets) * 1e4;
  }
  x[count - 2] = x[facets];
  x[count - 1] = x[0];
  y[count - 2] = y[count - 1] = 2e4 * (double)facets;
}

/* A mated outline of numbers over 10^4, written to 10^-6, and its scene in a folder of their own.
 */
static void measure_drawn(const char *name, void (*draw)(double *x, double *y, long count)) {
  char folder[] = "/tmp/topple-bench-XXXXXX", csv[64], yaml[64];
  if (mkdtemp(folder) == NULL) fail("no temporary folder");
  snprintf(csv, sizeof csv, "%s/outline.csv", folder);
  snprintf(yaml, sizeof yaml, "%s/scene.yaml", folder);
  static double x[VERTICES], y[VERTICES];
  draw(x, y, VERTICES);
  FILE *file = fopen(csv, "w");
  if (file == NULL) fail("no temporary file");
  fprintf(file, "x,y\n");
  for (long k = 0; k < VERTICES; k++) fprintf(file, "%.6f,%.6f\n", x[k] / 1e4, y[k] / 1e4);
  fclose(file);
  file = fopen(yaml, "w");
  if (file == NULL) fail("no temporary file");
  fprintf(file, "topple: 1\nlength_unit: mm\nblock: {outline: outline.csv}\nbase: {mated: true}\n"
                "friction_angle_deg: 30\ntilt: {towards: left}\n");
  fclose(file);
  measure(name, yaml);
  unlink(csv);
  unlink(yaml);
  rmdir(folder);
}

int main(int argc, char **argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: bench_limit SCENE\n");
    return 2;
  }
  printf("%-18s %12s    %10s\n", "static limit", "median", "ratio");
  measure("block E", argv[1]);
  measure_drawn("rough base", tp_rough_outline);
  measure_drawn("bowl", bowl);
  flint_cleanup();
  return 0;
}
