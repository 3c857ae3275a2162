/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the tilt test of a rigid block costs, on blocks A towards its peak, E towards its valley and
 * F: the tilt at which it begins to move, set down at each of 11 angles, so that the bracket is
 * 0.05 degrees wide; the same on a table that tilts at 20 degrees a minute, up to the begin; and on
 * to the end of the fall. Medians of 9 of the time computed. */

#include "bench.h"

#include "rigid_contact/rigid_contact.h"

#include <gsl/gsl_sort.h>
#include <math.h>

enum { SAMPLES = 9 };

static const double degree = 3.141592653589793 / 180;

static void fail(const char *what) {
  fprintf(stderr, "bench_rigid_contact: %s\n", what);
  exit(BENCH_FAILED);
}

typedef struct block {
  const char *name;
  const char *teeth;
} block;

static const block blocks[] = {
    {"A, peak", "{count: 3, width: 15, height: 94, depth: 5, left_end: peak}"},
    {"E, valley", "{count: 3, width: 30, height: 120, depth: 5, left_end: valley}"},
    {"F", "{count: 2, width: 30, height: 118, depth: 5, left_end: valley}"}};

static void body_init(tp_rigid_body *body, const block *own) {
  char text[400];
  tp_scene *scene = NULL;
  tp_problem problem;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  tp_solution *noted = calloc(1, sizeof *noted);
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: mm\nblock: {teeth: %s, thickness: 20, unit_weight_kn_m3: "
           "25.8}\nbase: {mated: true, beyond: {left: 0, right: 0}}\nfriction_angle_deg: 30\n",
           own->teeth);
  if (noted == NULL || tp_scene_read_text(&scene, text, "block", &message) != TP_OK ||
      tp_problem_init(&problem, scene, &options, noted, &message) != TP_OK ||
      tp_rigid_body_init(body, &problem, TP_TOWARDS_LEFT, &message) != TP_OK) {
    fail(message.text);
  }
  tp_problem_clear(&problem);
  tp_solution_free(noted);
  tp_scene_free(scene);
}

/* 90 degrees halved 11 times. */
static double set_down(const tp_rigid_body *body) {
  double low = 0, high = 90;
  while (high - low > 0.05) {
    const double middle = (low + high) / 2;
    const tp_drive drive = {.angle = middle * degree};
    const tp_run run = {.body = body, .drive = &drive};
    tp_rigid_contact_rest rest;
    if (!tp_rigid_contact_rest_find(&rest, &run)) fail("out of memory");
    *(rest.motion_count > 0 ? &high : &low) = middle;
  }
  return high;
}

static double run_ramp(const tp_rigid_body *body, bool until_collapse) {
  const tp_drive drive = {.speed = 20 * degree / 60, .final_angle = 80 * degree};
  const tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  tp_history history = {0};
  tp_message message = {.text = ""};
  const tp_run run = {.body = body,
                      .drive = &drive,
                      .longest_s = 240,
                      .until_collapse = until_collapse,
                      .history = &history};
  const tp_run_end end = tp_rigid_contact_run(NULL, NULL, &run, &settings, &message);
  double angle = NAN;
  for (size_t k = 0; k < history.event_count; k++) {
    if (history.events[k].what == TP_EVENT_COLLAPSES) angle = history.events[k].angle_deg;
  }
  tp_history_clear(&history);
  if (end == TP_RUN_UNDECIDED || isnan(angle)) fail(message.text);
  return angle;
}

static double way(const tp_rigid_body *body, int kind) {
  return kind == 0 ? set_down(body) : run_ramp(body, kind == 1);
}

int main(void) {
  static const char *const ways[] = {"bracket of 0.05 deg", "table, to the begin",
                                     "table, to the end"};
  for (size_t b = 0; b < sizeof blocks / sizeof *blocks; b++) {
    tp_rigid_body body;
    body_init(&body, blocks + b);
    for (int kind = 0; kind < 3; kind++) {
      double seconds[SAMPLES], angle = 0;
      for (int k = 0; k < SAMPLES; k++) {
        const double began = bench_computed();
        angle = way(&body, kind);
        seconds[k] = bench_computed() - began;
      }
      gsl_sort(seconds, 1, SAMPLES);
      printf("rigid contact, %-10s %-20s %8.3f ms   begins to move at %.4f deg\n", blocks[b].name,
             ways[kind], 1e3 * gsl_stats_median_from_sorted_data(seconds, 1, SAMPLES), angle);
    }
    tp_rigid_body_clear(&body);
  }
  return 0;
}
