/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table 3 of the paper by contact springs, and what that costs.
 *
 * Each row set down at a tilt on its springs and let go, with the paper's stiffness (1000 and 10
 * GPa/m), corners of 1e-7 m, friction of 30 degrees and local damping of 0.8; the least tilt at
 * which it collapses halved down from 0 and 60 degrees to 0.01. On a base that ends with the block,
 * and on one that goes on by a tooth. Beside it the onset of motion that the solve proves, and the
 * paper's physical and numerical angles. `ms`: of a bracket of 0.05 degrees on the short base, from
 * 0 and 60 degrees. With the argument `ramp` also the tilt at which a table raised by 20 degrees a
 * minute from level lets it go on the short base, with what each of these runs takes: minutes in
 * all. The rows are lines of a table of Markdown, as docs/tilt_springs.md has them. */

#include "bench.h"

#include "contact_springs/springs.h"
#include "topple.h"

#include <math.h>
#include <string.h>

typedef struct row {
  const char *model, *axis, *left_end;
  tp_direction towards;
  int count, a, b, c;               /* teeth; their size in mm */
  const char *physical, *numerical; /* of the paper, degrees; *: it slides */
} row;

static const row rows[] = {
    {"A", "peak", "peak", TP_TOWARDS_LEFT, 3, 15, 94, 5, "23.5", "26.2"},
    {"A", "valley", "valley", TP_TOWARDS_LEFT, 3, 15, 94, 5, "19.8", "23.9"},
    {"B", "peak", "peak", TP_TOWARDS_LEFT, 3, 14, 135, 5, "15.0", "17.6"},
    {"B", "valley", "valley", TP_TOWARDS_LEFT, 3, 14, 135, 5, "12.6", "16.4"},
    {"C", "valley", "valley", TP_TOWARDS_LEFT, 4, 20, 158, 7, "21.7", "25.3"},
    {"C", "valley", "valley", TP_TOWARDS_RIGHT, 4, 20, 158, 7, "21.4", "25.3"},
    {"D", "peak", "peak", TP_TOWARDS_LEFT, 4, 20, 242, 7, "15.3", "18.5"},
    {"D", "peak", "peak", TP_TOWARDS_RIGHT, 4, 20, 242, 7, "15.1", "18.5"},
    {"E", "valley", "valley", TP_TOWARDS_LEFT, 3, 30, 120, 5, "26.7\\*", "27.5\\*"},
    {"E", "peak", "peak", TP_TOWARDS_LEFT, 3, 30, 120, 5, "37.4", "37.4"},
    {"F", "valley", "valley", TP_TOWARDS_LEFT, 2, 30, 118, 5, "20.5\\*", "20.5\\*"},
    {"F", "valley", "valley", TP_TOWARDS_RIGHT, 2, 30, 118, 5, "20.5\\*", "20.5\\*"},
    {"G", "peak", "peak", TP_TOWARDS_LEFT, 2, 30, 123, 5, "23.8", "26.4"},
    {"G", "peak", "peak", TP_TOWARDS_RIGHT, 2, 30, 123, 5, "23.9", "26.4"},
};

static const tp_spring_settings springs = {
    .normal_pa_m = 1e12, .shear_pa_m = 1e10, .damping = 0.8, .rounding_m = 1e-7};

static tp_message message;

static void expect(bool done) {
  if (done) return;
  fprintf(stderr, "bench_springs: %s\n", message.text);
  exit(BENCH_FAILED);
}

/* The body of a row on one of its bases, and the onset of motion there in degrees. */
static void make(tp_rigid_body *body, double *onset_deg, const row *r, bool goes_on) {
  char text[500];
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: %d, width: %d, height: %d, depth: "
           "%d, left_end: %s}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: true, "
           "beyond: {left: %d, right: %d}}\nfriction_angle_deg: 30\ntilt: {towards: %s}\n",
           r->count, r->a, r->b, r->c, r->left_end, goes_on ? r->a : 0, goes_on ? r->a : 0,
           r->towards == TP_TOWARDS_LEFT ? "left" : "right");
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *scene = NULL;
  tp_solution *solution = NULL, *noted = calloc(1, sizeof *noted);
  tp_problem problem;
  expect(noted != NULL && tp_scene_read_text(&scene, text, r->model, &message) == TP_OK);
  expect(tp_solve(&solution, scene, &options, &message) == TP_OK);
  *onset_deg = solution->cases->onset.critical_angle_deg.value;
  expect(tp_problem_init(&problem, scene, &options, noted, &message) == TP_OK);
  expect(tp_rigid_body_init(body, &problem, r->towards, &message) == TP_OK);
  tp_problem_clear(&problem);
  tp_solution_free(noted);
  tp_solution_free(solution);
  tp_scene_free(scene);
}

static double radians(double degrees) {
  return degrees * acos(0) / 90;
}

static bool stands(const tp_rigid_body *body, double tilt_deg) {
  const tp_drive drive = {.angle = radians(tilt_deg)};
  const tp_run run = {.body = body, .drive = &drive, .longest_s = 20, .until_collapse = true};
  tp_body_state last;
  const tp_run_end end = tp_springs_run(&last, &run, &springs, &message);
  expect(end != TP_RUN_NO_MEMORY);
  return end == TP_RUN_STANDS || end == TP_RUN_RESTS;
}

static void bracket(double *low_deg, double *high_deg, const tp_rigid_body *body, double width) {
  *low_deg = 0;
  *high_deg = 60;
  while (*high_deg - *low_deg > width) {
    const double middle = (*low_deg + *high_deg) / 2;
    if (stands(body, middle)) {
      *low_deg = middle;
    } else {
      *high_deg = middle;
    }
  }
}

/* The tilt of a table of 20 degrees a minute at which it collapses. */
static double ramp(const tp_rigid_body *body, double *seconds) {
  const tp_drive drive = {.speed = radians(20) / 60, .final_angle = radians(60)};
  tp_history history = {0};
  const tp_run run = {
      .body = body, .drive = &drive, .longest_s = 200, .until_collapse = true, .history = &history};
  tp_body_state last;
  const double began = bench_computed();
  expect(tp_springs_run(&last, &run, &springs, &message) == TP_RUN_MOVES);
  *seconds = bench_computed() - began;
  double angle = NAN;
  for (size_t k = 0; k < history.event_count; k++) {
    if (history.events[k].what == TP_EVENT_COLLAPSES) angle = history.events[k].angle_deg;
  }
  tp_history_clear(&history);
  return angle;
}

static void print_row(const row *r, bool with_ramp) {
  double low[2], high[2], onset[2], ms = 0, ramp_deg = 0, ramp_s = 0;
  for (int k = 0; k < 2; k++) {
    tp_rigid_body body;
    make(&body, onset + k, r, k == 1);
    bracket(low + k, high + k, &body, 0.01);
    if (k == 0) {
      double wide_low, wide_high;
      const double began = bench_computed();
      bracket(&wide_low, &wide_high, &body, 0.05);
      ms = 1000 * (bench_computed() - began);
      if (with_ramp) ramp_deg = ramp(&body, &ramp_s);
    }
    tp_rigid_body_clear(&body);
  }
  printf("| %s | %s | %s | %s | %.3f–%.3f | %.3f | %.3f–%.3f | %.3f | %.0f |", r->model, r->axis,
         r->physical, r->numerical, low[0], high[0], onset[0], low[1], high[1], onset[1], ms);
  if (with_ramp) printf(" %.3f | %.1f |", ramp_deg, ramp_s);
  puts("");
}

int main(int argc, char **argv) {
  const bool with_ramp = argc > 1 && strcmp(argv[1], "ramp") == 0;
  printf("| block | axis | physical | paper's numerical | springs, short base | onset | springs, "
         "long base | onset | ms |%s\n",
         with_ramp ? " ramp | s |" : "");
  printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |%s\n",
         with_ramp ? " --- | --- |" : "");
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) print_row(rows + k, with_ramp);
  return 0;
}
