/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a bracket of 0.05 degrees of the tilt at which a block begins to move costs, and how far it
 * is off: blocks A towards its peak, E towards its valley and F, by the quasi-static path from
 * level, by events and by springs (1000 and 10 GPa/m) set down at tilts between 0 and 60 degrees
 * that are halved, and likewise by Box2D at 1 kHz where it is installed. The methods take turns, so
 * that a busy machine is shared by all; medians of the time computed, their ratio to Box2D's, and
 * the middle of the bracket less the proven onset, which is the limit here. */

#include "bench.h"
#include "box2d.h"

#include "contact_springs/springs.h"
#include "quasi_static/path.h"
#include "rigid_contact/rigid_contact.h"
#include "topple.h"

#include <gsl/gsl_sort.h>
#include <math.h>

enum { SAMPLES = 7, MOST_UNDER = 16, MOST_BASE = 64 };

static const double degree = 3.141592653589793 / 180, width_deg = 0.05, highest_deg = 60;

static tp_message message;

static void expect(bool done) {
  if (done) return;
  fprintf(stderr, "bench_tilt: %s\n", message.text);
  exit(BENCH_FAILED);
}

typedef struct block {
  const char *name, *teeth;
  tp_rigid_body body;
  double onset_deg;
  double under[2 * MOST_UNDER], base[2 * MOST_BASE];
  box2d_block box2d;
} block;

static block blocks[] = {
    {.name = "A, peak", .teeth = "{count: 3, width: 15, height: 94, depth: 5, left_end: peak}"},
    {.name = "E, valley",
     .teeth = "{count: 3, width: 30, height: 120, depth: 5, left_end: valley}"},
    {.name = "F", .teeth = "{count: 2, width: 30, height: 118, depth: 5, left_end: valley}"}};

/* The outline runs counter-clockwise: its underside to the right, its top back to the left. */
static void set_box2d(block *own) {
  const tp_rigid_body *body = &own->body;
  double top = -INFINITY;
  for (long k = 0; k < body->outline.count; k++) top = fmax(top, body->outline.edges[k].from.y);
  long first = 0; /* the upper left corner comes before the underside */
  while (!(body->outline.edges[first].from.y == top && body->outline.edges[first].to.y < top)) {
    first++;
  }
  int count = 0;
  for (long k = 1; k < body->outline.count && count < MOST_UNDER; k++) {
    const tp_edge *edge = body->outline.edges + (first + k) % body->outline.count;
    if (edge->from.y == top) break;
    own->under[2 * count] = edge->from.x;
    own->under[2 * count++ + 1] = edge->from.y;
  }
  for (long k = 0; k < body->base.count && k < MOST_BASE; k++) {
    own->base[2 * k] = body->base.edges[k].from.x;
    own->base[2 * k + 1] = body->base.edges[k].from.y;
  }
  own->box2d = (box2d_block){.under = own->under,
                             .under_count = count,
                             .top = top,
                             .base = own->base,
                             .base_count = (int)fmin(MOST_BASE, (double)body->base.count),
                             .friction = tan(30 * degree),
                             .extent = body->extent_m};
}

static void init(block *own) {
  char text[400];
  tp_scene *scene = NULL;
  tp_problem problem;
  const tp_solve_options options = tp_solve_options_default();
  tp_solution *solution = NULL, *noted = calloc(1, sizeof *noted);
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: mm\nblock: {teeth: %s, thickness: 20, unit_weight_kn_m3: "
           "25.8}\nbase: {mated: true, beyond: {left: 0, right: 0}}\nfriction_angle_deg: 30\n"
           "tilt: {towards: left}\n",
           own->teeth);
  expect(noted != NULL && tp_scene_read_text(&scene, text, "block", &message) == TP_OK);
  expect(tp_solve(&solution, scene, &options, &message) == TP_OK);
  own->onset_deg = solution->cases->onset.critical_angle_deg.value;
  expect(tp_problem_init(&problem, scene, &options, noted, &message) == TP_OK);
  expect(tp_rigid_body_init(&own->body, &problem, TP_TOWARDS_LEFT, &message) == TP_OK);
  tp_problem_clear(&problem);
  tp_solution_free(noted);
  tp_solution_free(solution);
  tp_scene_free(scene);
  set_box2d(own);
}

/* ---- the methods: the middle of the bracket, degrees -------------------------------------------
 */

static double by_path(const block *own) {
  tp_path_settings settings = tp_path_settings_default();
  tp_path_result result;
  settings.tolerance = width_deg * degree;
  settings.moments_every = 0;
  expect(tp_path_run(&result, &own->body, &settings, NULL, &message) == TP_OK);
  return (result.stands_to + result.collapses_at) / (2 * degree);
}

static double halved(const block *own, bool (*stands)(const block *own, double tilt)) {
  double low = 0, high = highest_deg;
  while (high - low > width_deg) {
    const double middle = (low + high) / 2;
    *(stands(own, middle * degree) ? &low : &high) = middle;
  }
  return (low + high) / 2;
}

static bool stands_by_events(const block *own, double tilt) {
  const tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  const tp_drive drive = {.angle = tilt, .final_angle = tilt};
  const tp_run run = {.body = &own->body, .drive = &drive, .longest_s = 10, .until_collapse = true};
  tp_rigid_contact_account account;
  tp_body_state last;
  return tp_rigid_contact_run(&last, &account, &run, &settings, &message) == TP_RUN_STANDS;
}

static bool stands_by_springs(const block *own, double tilt) {
  static const tp_spring_settings springs = {
      .normal_pa_m = 1e12, .shear_pa_m = 1e10, .damping = 0.8, .rounding_m = 1e-7};
  const tp_drive drive = {.angle = tilt, .final_angle = tilt};
  const tp_run run = {.body = &own->body, .drive = &drive, .longest_s = 10, .until_collapse = true};
  tp_body_state last;
  return tp_springs_run(&last, &run, &springs, &message) == TP_RUN_STANDS;
}

static double by_events(const block *own) {
  return halved(own, stands_by_events);
}

static double by_springs(const block *own) {
  return halved(own, stands_by_springs);
}

#ifdef HAVE_BOX2D
static bool stands_by_box2d(const block *own, double tilt) {
  return box2d_stands(&own->box2d, tilt);
}

static double by_box2d(const block *own) {
  return halved(own, stands_by_box2d);
}
#endif

static const struct {
  const char *name;
  double (*angle)(const block *own);
} methods[] = {
    {"path", by_path},
    {"events", by_events},
    {"springs", by_springs},
#ifdef HAVE_BOX2D
    {"Box2D", by_box2d},
#endif
};

enum { METHODS = sizeof methods / sizeof methods[0] };

static void report(const block *own) {
  double seconds[METHODS][SAMPLES], angle[METHODS];
  for (int sample = 0; sample < SAMPLES; sample++) {
    for (int k = 0; k < METHODS; k++) {
      long runs = 0;
      const double began = bench_computed();
      for (; runs == 0 || bench_computed() - began < 5e-3; runs++) angle[k] = methods[k].angle(own);
      seconds[k][sample] = (bench_computed() - began) / (double)runs;
    }
  }
  for (int k = 0; k < METHODS; k++) gsl_sort(seconds[k], 1, SAMPLES);
  const double last = seconds[METHODS - 1][SAMPLES / 2];
  for (int k = 0; k < METHODS; k++) {
    const double median = seconds[k][SAMPLES / 2];
    printf("| %s | %s | %.3f | %.2g | %.3f | %+.3f |\n", own->name, methods[k].name, 1e3 * median,
           median / last, angle[k], angle[k] - own->onset_deg);
  }
}

int main(void) {
  printf("| block | method | ms | over %s | bracket about, degrees | off the onset |\n",
         methods[METHODS - 1].name);
  puts("| --- | --- | --- | --- | --- | --- |");
  for (size_t k = 0; k < sizeof blocks / sizeof blocks[0]; k++) {
    init(blocks + k);
    report(blocks + k);
    tp_rigid_body_clear(&blocks[k].body);
  }
  return 0;
}
