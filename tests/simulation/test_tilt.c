/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The protocols of a tilt test over an engine of the test, which knows its critical angle, and the
 * shaking of a base against integrals and sums. */

#include "shaking/shaking.h"
#include "suite.h"
#include "tilt/bracket.h"
#include "tilt/follow.h"

#include <math.h>
#include <string.h>

/* ---- an engine --------------------------------------------------------------------------------
 */

/* Of a block that begins to move at a tilt, to the left about a corner, and has no memory. */
typedef struct corner_block {
  double lets_go;    /* radians */
  double open_above; /* of tilts beyond that no run is decided */
  size_t runs;
  double longest_s;
} corner_block;

static tp_run_end run_corner(tp_body_state *last, const tp_run *run, void *engine,
                             tp_message *message) {
  corner_block *own = engine;
  (void)message;
  const double angle = run->drive->final_angle;
  own->runs++;
  own->longest_s = run->longest_s;
  /* turns about (-0.5, -1), counter-clockwise */
  *last = (tp_body_state){.speed = {-1, 0.5}, .turning = 1};
  if (angle > own->open_above) return TP_RUN_UNDECIDED;
  if (angle < own->lets_go) return TP_RUN_STANDS;
  if (run->history != NULL) {
    const tp_tilt_event event = {.what = TP_EVENT_COLLAPSES,
                                 .time_s = (own->lets_go - run->drive->angle) / run->drive->speed,
                                 .angle_deg = tp_tilt_degrees(own->lets_go)};
    const tp_tilt_event later = {.what = TP_EVENT_OPENS, .time_s = event.time_s + 1};
    ck_assert(tp_history_event(run->history, event) && tp_history_event(run->history, later));
  }
  return TP_RUN_MOVES;
}

typedef struct stage {
  corner_block block;
  tp_closed_point corner;
  tp_rigid_body body;
  tp_tilt_settings settings;
  tp_tilt_options options;
  tp_tilt_case own;
  tp_message message;
  tp_tilting tilting;
} stage;

static void begin(stage *s, double lets_go_deg) {
  memset(s, 0, sizeof *s);
  s->block = (corner_block){tp_tilt_radians(lets_go_deg), 10, 0, 0};
  s->corner.at = (tp_xy){-0.5, -1};
  s->body = (tp_rigid_body){.closed_count = 1, .closed = &s->corner, .extent_m = 1, .mass_kg = 1};
  s->settings = (tp_tilt_settings){.engine = TP_TILT_RIGID,
                                   .protocol = TP_TILT_STEPS,
                                   .set_down = true,
                                   .until_deg = 90,
                                   .tolerance_deg = 1e-6};
  s->options = tp_tilt_options_default();
  s->tilting = (tp_tilting){.body = &s->body,
                            .settings = &s->settings,
                            .options = &s->options,
                            .engine = {run_corner, &s->block},
                            .own = &s->own,
                            .message = &s->message};
}

static void check_bracket(const stage *s, double lets_go_deg) {
  ck_assert(s->own.has_bracket && s->own.converged);
  ck_assert_double_le(s->own.stands_at_deg, lets_go_deg);
  ck_assert_double_ge(s->own.lets_go_at_deg, lets_go_deg);
  ck_assert_double_le(s->own.lets_go_at_deg - s->own.stands_at_deg, s->settings.tolerance_deg);
}

/* ---- brackets ---------------------------------------------------------------------------------
 */

/* Where statics is right two runs do; where it is wrong, on either side, the runs decide. */
START_TEST(steps_bracket_whatever_was_expected) {
  static const double guesses[][2] = {
      {19.9999999, 20.0000001}, {10, 12}, {30, 40}, {0, 0}, {89, 95}};
  for (size_t k = 0; k < 5; k++) {
    stage s;
    begin(&s, 20);
    ck_assert_int_eq(
        tp_tilting_bracket(&s.tilting, tp_tilting_look, guesses[k][0], guesses[k][1], 90), TP_OK);
    check_bracket(&s, 20);
    if (k == 0) ck_assert_uint_eq(s.own.runs, 2);
    ck_assert_uint_le(s.own.runs, 31); /* log2(90 / 1e-6), and what was expected */
    ck_assert_uint_eq(s.own.runs, s.block.runs);
  }
}
END_TEST

START_TEST(blocks_that_never_or_always_let_go) {
  stage s;
  begin(&s, 200);
  ck_assert_int_eq(tp_tilting_bracket(&s.tilting, tp_tilting_look, 0, 0, 90), TP_OK);
  ck_assert(!s.own.has_bracket && s.own.converged && s.own.stands_at_deg == 90);
  begin(&s, -1);
  ck_assert_int_eq(tp_tilting_bracket(&s.tilting, tp_tilting_look, 0, 0, 90), TP_OK);
  ck_assert(s.own.has_bracket && s.own.lets_go_at_deg == 0);
}
END_TEST

/* A run that is not decided ends the search, and what is known by then stays. */
START_TEST(undecided_runs_are_told) {
  stage s;
  begin(&s, 20);
  s.block.open_above = tp_tilt_radians(15);
  ck_assert_int_eq(tp_tilting_bracket(&s.tilting, tp_tilting_look, 12, 0, 90), TP_OK);
  ck_assert(!s.own.has_bracket && !s.own.converged && s.own.stands_at_deg == 12);
  ck_assert_int_eq(s.own.end, TP_TILT_OPEN);
}
END_TEST

static bool after_four(void *context) {
  return ((const corner_block *)context)->runs >= 4;
}

START_TEST(a_test_that_is_stopped_has_its_bracket) {
  stage s;
  begin(&s, 20);
  s.options.stop = after_four;
  s.options.context = &s.block;
  ck_assert_int_eq(tp_tilting_bracket(&s.tilting, tp_tilting_look, 0, 0, 90), TP_OK);
  ck_assert(s.own.has_bracket && !s.own.converged);
  ck_assert_uint_eq(s.own.runs, 4);
  ck_assert_int_eq(s.own.end, TP_TILT_STOPPED);
  ck_assert(s.own.stands_at_deg <= 20 && s.own.lets_go_at_deg >= 20);
}
END_TEST

/* A ramp ends its history where it begins to move; tables that stop before it bracket that. */
START_TEST(ramps_end_their_history_where_they_let_go) {
  stage s;
  begin(&s, 20);
  s.settings.protocol = TP_TILT_RAMP;
  s.settings.set_down = false;
  s.settings.speed_deg_min = 20;
  s.settings.duration_s = 2;
  ck_assert_int_eq(tp_tilting_ramp(&s.tilting), TP_OK);
  check_bracket(&s, 20);
  ck_assert_uint_eq(s.tilting.history.event_count, 1);
  ck_assert_double_eq_tol(s.tilting.history.events[0].time_s, 60, 1e-9); /* 20 degrees a minute */
  ck_assert_double_eq_tol(s.block.longest_s, 62, 1e-5);
  tp_history_clear(&s.tilting.history);
}
END_TEST

START_TEST(mechanisms_by_the_velocity) {
  const tp_closed_point corner = {.at = {-0.5, -1}};
  tp_closed_point closed[] = {corner};
  const tp_rigid_body body = {.closed_count = 1, .closed = closed, .extent_m = 1};
  tp_xy centre = {0, 0};
  bool has = false;
  const tp_body_state topples = {.speed = {-1, 0.5}, .turning = 1};
  /* v = omega x r: of the centroid about (-0.5, -1), (-1, 0.5) a radian a second */
  ck_assert_int_eq(tp_tilting_mechanism(&centre, &has, &body, &topples), TP_TOPPLES);
  ck_assert(has);
  ck_assert_double_eq_tol(centre.x, -0.5, 1e-15);
  ck_assert_double_eq_tol(centre.y, -1, 1e-15);
  const tp_body_state both = {.speed = {-2, 0.5}, .turning = 1};
  ck_assert_int_eq(tp_tilting_mechanism(&centre, &has, &body, &both), TP_SLIDES_AND_TOPPLES);
  const tp_body_state slides = {.speed = {-2, 0.5}};
  ck_assert_int_eq(tp_tilting_mechanism(&centre, &has, &body, &slides), TP_SLIDES);
  ck_assert(!has);
  const tp_body_state rests = {.turned = 1};
  ck_assert_int_eq(tp_tilting_mechanism(&centre, &has, &body, &rests), TP_MECHANISM_UNDECIDED);
}
END_TEST

/* ---- shaking ----------------------------------------------------------------------------------
 */

/* Velocity at the end and its greatest absolute value by Simpson's rule, from kink to kink. */
static tp_shaking_peaks by_simpson(const tp_base_acceleration *axis) {
  enum { PARTS = 2000 };
  tp_shaking_peaks peaks = {0};
  double at = 0, velocity = 0;
  for (double next = tp_base_acceleration_next_kink(axis, at); isfinite(next);
       at = next, next = tp_base_acceleration_next_kink(axis, at)) {
    const double step = (next - at) / PARTS;
    for (int k = 0; k < PARTS; k++) {
      const double from = at + k * step;
      velocity += step / 6 *
                  (tp_base_acceleration_at(axis, from) +
                   4 * tp_base_acceleration_at(axis, from + step / 2) +
                   tp_base_acceleration_at(axis, fmin(next, from + step)));
      peaks.velocity_m_s = fmax(peaks.velocity_m_s, fabs(velocity));
      peaks.acceleration_m_s2 =
          fmax(peaks.acceleration_m_s2, fabs(tp_base_acceleration_at(axis, from)));
    }
    peaks.duration_s = next;
  }
  peaks.last_velocity_m_s = velocity;
  return peaks;
}

static void check_peaks(const tp_base_acceleration *axis) {
  const tp_shaking_peaks told = tp_base_acceleration_peaks(axis), own = by_simpson(axis);
  ck_assert_double_eq_tol(told.acceleration_m_s2, own.acceleration_m_s2, 1e-5);
  ck_assert_double_eq_tol(told.velocity_m_s, own.velocity_m_s, 1e-6);
  ck_assert_double_eq_tol(told.last_velocity_m_s, own.last_velocity_m_s, 1e-12);
  ck_assert_double_eq_tol(told.duration_s, own.duration_s, 1e-15);
}

START_TEST(peaks_are_integrals) {
  const tp_base_acceleration half = {
      .form = TP_SHAKING_HALF_SINE, .peak_m_s2 = 4, .frequency_hz = 2};
  const tp_base_acceleration full = {
      .form = TP_SHAKING_FULL_SINE, .peak_m_s2 = -3, .frequency_hz = 1.5};
  double times[] = {0, 0.1, 0.2, 0.3, 0.4}, values[] = {0, 1, -2, -1, 0.5};
  const tp_base_acceleration record = {
      .form = TP_SHAKING_RECORD, .count = 5, .time_s = times, .value_m_s2 = values};
  check_peaks(&half);
  check_peaks(&full);
  check_peaks(&record);
  /* the area under half a sine is its peak over pi f */
  ck_assert_double_eq_tol(tp_base_acceleration_peaks(&half).velocity_m_s, 4 / (2 * M_PI), 1e-15);
  ck_assert_double_eq_tol(tp_base_acceleration_at(&record, 0.15), -0.5, 1e-15);
  ck_assert_double_eq(tp_base_acceleration_at(&record, 0.41), 0);
  ck_assert_double_eq(tp_base_acceleration_at(&half, -0.1), 0);
}
END_TEST

SUITE(tilt) {
  Suite *suite = suite_create("tilt");
  TCase *tests = tcase_create("tilt");
  tcase_add_test(tests, steps_bracket_whatever_was_expected);
  tcase_add_test(tests, blocks_that_never_or_always_let_go);
  tcase_add_test(tests, undecided_runs_are_told);
  tcase_add_test(tests, a_test_that_is_stopped_has_its_bracket);
  tcase_add_test(tests, ramps_end_their_history_where_they_let_go);
  tcase_add_test(tests, mechanisms_by_the_velocity);
  tcase_add_test(tests, peaks_are_integrals);
  suite_add_tcase(suite, tests);
  return suite;
}
