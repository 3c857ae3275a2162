/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the static limit and the onset of motion cost beside each other on mated bases of 10^5
 * facets: rough, waves, an arc of a circle, an arch and a bowl; and what a rough base of 10^4 with
 * cohesion, and with a bond too, takes as a whole.
 *
 * By the seconds that tp_solve tells of its effects, one direction, 9 digits, no tilt given; each
 * column a median of its own, `ratio` that of onset over limit. */

#include "bench.h"
#include "random_numbers.h"

#include "topple.h"

#include <math.h>
#include <string.h>

enum { FACETS = 100000, FEW = 10000, SAMPLES = 3, RISE = 600000 };

static void fail(const char *what) {
  fprintf(stderr, "bench_bases: %s\n", what);
  exit(BENCH_FAILED);
}

/* Heights in mm over u from 0 to 1 along the base, 10 mm a facet. */
static double rough(double u) {
  static random_numbers numbers;
  if (u == 0) numbers = random_numbers_from(3);
  return 1000 + 9 * draw_part(&numbers);
}

static double fine_wave(double u) {
  return 1000 + 40 * sin(2 * M_PI * u * FACETS / 40);
}

static double coarse_wave(double u) {
  return 100000 + 10000 * sin(6 * M_PI * u);
}

static double arc(double u) {
  return 2e6 * (1 - sqrt(1 - (u - 0.5) * (u - 0.5) / 4));
}

static double arch(double u) {
  return 400000 * u * (1 - u);
}

static double bowl(double u) {
  return 200000 - 800000 * u * (1 - u);
}

typedef struct base {
  const char *name;
  double (*height)(double u);
  long facets;
  const char *loads;
} base;

static const base bases[] = {
    {"rough", rough, FACETS, ""},
    {"fine wave", fine_wave, FACETS, ""},
    {"coarse wave", coarse_wave, FACETS, ""},
    {"arc", arc, FACETS, ""},
    {"arch", arch, FACETS, ""},
    {"bowl", bowl, FACETS, ""},
    {"cohesion", rough, FEW, "loads: {cohesion_kpa: 5}\n"},
    {"cohesion, bond", rough, FEW, "loads: {cohesion_kpa: 5, bond_kpa: 5}\n"}};

static tp_scene *make_scene(const base *b) {
  enum { MOST_OF_VERTEX = 40, MOST_OF_REST = 500 };
  char *text = malloc((size_t)(b->facets + 1) * MOST_OF_VERTEX + MOST_OF_REST), *at = text;
  if (text == NULL) fail("out of memory");
  double y = 0, first = 0, top = 0;
  at = stpcpy(at, "topple: 1\nlength_unit: mm\nblock:\n  unit_weight_kn_m3: 26\n  outline: [");
  for (long k = 0; k <= b->facets; k++) {
    y = b->height((double)k / (double)b->facets);
    if (k == 0) first = y;
    top = fmax(top, y);
    at += sprintf(at, "[%ld, %.6f], ", 10 * k, y);
  }
  sprintf(at,
          "[%ld, %.6f], [0, %.6f]]\nbase: {mated: true, between: [[0, %.6f], [%ld, %.6f]]}\n%s"
          "friction_angle_deg: 30\ntilt: {towards: left}\n",
          10 * b->facets, top + RISE, top + RISE, first, 10 * b->facets, y, b->loads);
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  if (tp_scene_read_text(&scene, text, b->name, &message) != TP_OK) fail(message.text);
  free(text);
  return scene;
}

static double seconds_of(const tp_solution *solution, const char *effect) {
  double seconds = 0;
  for (size_t k = 0; k < solution->effect_count; k++) {
    if (strcmp(solution->effects[k].name, effect) == 0) seconds += solution->effects[k].seconds;
  }
  return seconds;
}

static void measure(const base *b) {
  double limit[SAMPLES], onset[SAMPLES], ratio[SAMPLES], whole[SAMPLES];
  const tp_solve_options options = tp_solve_options_default();
  tp_message message = {.text = ""};
  tp_scene *scene = make_scene(b);
  for (int s = 0; s < SAMPLES; s++) {
    tp_solution *solution = NULL;
    const double began = bench_computed();
    if (tp_solve(&solution, scene, &options, &message) != TP_OK) fail(message.text);
    whole[s] = bench_computed() - began;
    limit[s] = seconds_of(solution, "limit");
    onset[s] = seconds_of(solution, "onset");
    ratio[s] = onset[s] / limit[s];
    tp_solution_free(solution);
  }
  tp_scene_free(scene);
  printf("%-16s %7ld %9.1f %9.1f %7.2f %9.1f\n", b->name, b->facets,
         1e3 * gsl_stats_median(limit, 1, SAMPLES), 1e3 * gsl_stats_median(onset, 1, SAMPLES),
         gsl_stats_median(ratio, 1, SAMPLES), 1e3 * gsl_stats_median(whole, 1, SAMPLES));
}

int main(void) {
  printf("%-16s %7s %9s %9s %7s %9s\n", "base", "facets", "limit ms", "onset ms", "ratio",
         "whole ms");
  for (size_t k = 0; k < sizeof bases / sizeof bases[0]; k++) measure(bases + k);
  printf("goal of the ratio: 3\n");
  return 0;
}
