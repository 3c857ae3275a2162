/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rigid contact from event to event, against what closed forms, quadrature and GSL's integrators
 * say of a block that rocks, slides, rolls and bounces. */

#include "rigid_contact/extrapolation.h"
#include "rocking.h"
#include "suite.h"

#include <gsl/gsl_odeiv2.h>
#include <math.h>

static const double pi = 3.141592653589793;

static void close_to(double value, double expected, double share, const char *what) {
  ck_assert_msg(fabs(value - expected) <= share * fabs(expected), "%s: %.17g, not %.17g", what,
                value, expected);
}

/* A run, and that its energy is balanced. */
static tp_run_end run_for(tp_history *history, tp_body_state *last, const tp_rigid_body *body,
                          const tp_drive *drive, const tp_body_state *start, double seconds,
                          double restitution, double least_bounce) {
  tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  tp_rigid_contact_account account;
  tp_message message = {0};
  settings.restitution = restitution;
  settings.least_bounce = least_bounce;
  const tp_run run = {
      .body = body, .drive = drive, .start = *start, .longest_s = seconds, .history = history};
  const tp_run_end end = tp_rigid_contact_run(last, &account, &run, &settings, &message);
  ck_assert_msg(end != TP_RUN_UNDECIDED && end != TP_RUN_NO_MEMORY, "%s", message.text);
  ck_assert_msg(account.worst_balance < 1e-11, "energy off by %g", account.worst_balance);
  ck_assert_msg(account.largest_drift < 1e-11, "contacts off by %g", account.largest_drift);
  return end;
}

static const tp_tilt_event *find_event(const tp_history *h, tp_tilt_event_kind kind, size_t nth) {
  for (size_t k = 0; k < h->event_count; k++) {
    if (h->events[k].what == kind && nth-- == 0) return h->events + k;
  }
  ck_abort_msg("no such event");
}

static const tp_drive level = {0};
static const double bounce = 1e-9;

/* The pendulum x'' = -sin x from 3 rad: a stiff top and a fast swing. */
static bool swing(double *rates, void *context, double time, const double *y) {
  (void)context;
  (void)time;
  for (int e = 0; e < TP_MOTION_NUMBERS; e++) rates[e] = 0;
  rates[0] = y[3];
  rates[3] = -sin(y[0]);
  return true;
}

static int swing_for_gsl(double time, const double y[], double rates[], void *context) {
  (void)time;
  (void)context;
  rates[0] = y[1];
  rates[1] = -sin(y[0]);
  return 0;
}

START_TEST(extrapolation_goes_where_a_runge_kutta_method_does) {
  enum { STEPS = 100 };
  double own[TP_MOTION_NUMBERS] = {3}, gsl[2] = {3, 0}, t = 0;
  gsl_odeiv2_system system = {swing_for_gsl, NULL, 2, NULL};
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 0);
  for (int k = 1; k <= STEPS; k++) {
    ck_assert(tp_extrapolate(own, swing, NULL, 0, own, 0.25, 1e-13).reached);
    ck_assert_int_eq(gsl_odeiv2_driver_apply(driver, &t, 0.25 * k, gsl), 0);
    /* the energy at the top is told to 1e-13, and errors grow by up to e per unit of time there */
    ck_assert_msg(fabs(own[0] - gsl[0]) < 1e-10, "%.17g, not %.17g", own[0], gsl[0]);
    ck_assert(fabs(own[3] * own[3] / 2 - cos(own[0]) + cos(3.0)) < 1e-11);
  }
  gsl_odeiv2_driver_free(driver);
}
END_TEST

START_TEST(quarter_of_a_period_is_that_of_the_quadrature) {
  static const double shapes[][2] = {{1, 4}, {1, 1.5}, {0.3, 3}};
  for (int k = 0; k < 3; k++) {
    rocking r;
    rocking_init(&r, shapes[k][0], shapes[k][1]);
    for (int part = 1; part < 10; part += 2) {
      tp_history h = {0};
      const double angle = r.alpha * part / 10;
      const tp_body_state start = rocking_turned(&r, angle);
      const double quarter = rocking_quarter_s(&r, angle);
      (void)run_for(&h, NULL, &r.stage.body, &level, &start, 1.5 * quarter, 0, bounce);
      close_to(find_event(&h, TP_EVENT_CLOSES, 0)->time_s, quarter, 1e-10, "quarter period");
      tp_history_clear(&h);
    }
    rocking_clear(&r);
  }
}
END_TEST

/* Housner's T = 4 / p acosh(1 / (1 - x / alpha)), to the square of alpha; so small that its impacts
 * come from falls of 1e-13 of it. */
START_TEST(slender_block_has_housners_period) {
  rocking r;
  rocking_init(&r, 0.001, 2);
  for (int part = 1; part < 10; part++) {
    tp_history h = {0};
    const double angle = r.alpha * part / 10;
    const tp_body_state start = rocking_turned(&r, angle);
    const double quarter = acosh(1 / (1 - angle / r.alpha)) / r.p;
    (void)run_for(&h, NULL, &r.stage.body, &level, &start, 1.5 * quarter, 0, 1e-16);
    close_to(find_event(&h, TP_EVENT_CLOSES, 0)->time_s, quarter, 1e-6, "quarter period");
    tp_history_clear(&h);
  }
  rocking_clear(&r);
}
END_TEST

/* From one impact to the next no energy is lost, so the toes come down with 1 - 3/2 sin^2(alpha)
 * times the speed of the time before, on either side in turn, until bounces no higher than 1e-9 of
 * the block are passed; then it rests where it stood. */
START_TEST(rocking_dies_out_by_the_restitution_of_angular_momentum) {
  rocking r;
  tp_history h = {0};
  tp_body_state last;
  rocking_init(&r, 1, 3);
  const tp_body_state start = rocking_turned(&r, 0.9 * r.alpha);
  const double ratio = 1 - 1.5 * sin(r.alpha) * sin(r.alpha);
  ck_assert_int_eq(run_for(&h, &last, &r.stage.body, &level, &start, 100, 0, bounce), TP_RUN_RESTS);
  size_t impacts = 0;
  for (size_t k = 0; k < h.event_count; k++) impacts += h.events[k].what == TP_EVENT_CLOSES;
  ck_assert_int_gt(impacts, 40);
  for (size_t k = 1; k < impacts; k++) {
    const tp_tilt_event *a = find_event(&h, TP_EVENT_CLOSES, k - 1);
    const tp_tilt_event *b = find_event(&h, TP_EVENT_CLOSES, k);
    const double expected = ratio * a->speed_m_s, energy = 1e-11 * TP_GRAVITY_M_S2 * r.radius_m;
    ck_assert(fabs(b->speed_m_s * b->speed_m_s - expected * expected) < energy);
    ck_assert((a->x_m < 0.5) != (b->x_m < 0.5));
  }
  (void)find_event(&h, TP_EVENT_ACCUMULATES, 0);
  (void)find_event(&h, TP_EVENT_RESTS, 0);
  ck_assert(fabs(last.moved.x) < 1e-7 && fabs(last.moved.y) < 1e-9 && fabs(last.turned) < 1e-8);
  tp_history_clear(&h);
  rocking_clear(&r);
}
END_TEST

static bool overturns(const rocking *r, const half_sine *pulse) {
  const tp_drive drive = {.shaking = &pulse->motion};
  const tp_body_state start = {0};
  tp_history h = {0};
  tp_body_state last;
  /* after so long it lies on its side, or has come back */
  const tp_run_end end = run_for(&h, &last, &r->stage.body, &drive, &start, 30 / r->p, 0, bounce);
  tp_history_clear(&h);
  return end == TP_RUN_OVERTURNED;
}

/* The least peak of half a sine that overturns the block, of the events and of the one equation. */
START_TEST(least_pulse_that_overturns_is_that_of_the_one_equation) {
  rocking r;
  rocking_init(&r, 1, 5);
  for (int k = 0; k < 2; k++) {
    const double frequency = (k == 0 ? 1.5 : 3) * r.p;
    double least[2];
    for (int way = 0; way < 2; way++) {
      double low = TP_GRAVITY_M_S2 * tan(r.alpha), high = 20 * low;
      while (high - low > 1e-8 * high) {
        half_sine pulse;
        half_sine_init(&pulse, (low + high) / 2, frequency);
        const bool over = way == 0 ? overturns(&r, &pulse) : rocking_overturns(&r, &pulse);
        *(over ? &high : &low) = pulse.peak_m_s2;
      }
      least[way] = high;
    }
    close_to(least[0], least[1], 1e-6, "least peak");
  }
  rocking_clear(&r);
}
END_TEST

#define INCLINE                                                                                    \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: 20\nblock: {slab: {width: 3, height: 1}}\n"      \
  "base: {mated: true, beyond: {left: 100, right: 10}}\n"

START_TEST(slab_slides_as_a_point_does) {
  const double tilt = 0.6, phi = pi / 9;
  body_stage s;
  tp_history h = {0};
  tp_body_state last;
  const tp_body_state start = {0};
  const tp_drive drive = {.angle = tilt};
  body_stage_init(&s, INCLINE, TP_TOWARDS_LEFT);
  ck_assert_int_eq(run_for(&h, &last, &s.body, &drive, &start, 3, 0, bounce), TP_RUN_MOVES);
  const double a = TP_GRAVITY_M_S2 * (sin(tilt) - tan(phi) * cos(tilt));
  close_to(-last.speed.x, a * 3, 1e-9, "speed");
  close_to(-last.moved.x, a * 9 / 2, 1e-9, "way");
  ck_assert(fabs(last.turned) < 1e-12 && fabs(last.moved.y) < 1e-12);
  tp_history_clear(&h);
  body_stage_clear(&s);
}
END_TEST

/* Thrown up a slope it stops, and stays: tan(20 deg) is more than that of the slope. */
START_TEST(slab_thrown_up_a_slope_stops_after_the_way_of_its_energy) {
  const double tilt = 0.2, phi = pi / 9, speed = 2;
  body_stage s;
  tp_history h = {0};
  tp_body_state last;
  const tp_body_state start = {.speed = {speed, 0}};
  const tp_drive drive = {.angle = tilt};
  body_stage_init(&s, INCLINE, TP_TOWARDS_LEFT);
  ck_assert_int_eq(run_for(&h, &last, &s.body, &drive, &start, 10, 0, bounce), TP_RUN_RESTS);
  const double a = TP_GRAVITY_M_S2 * (sin(tilt) + tan(phi) * cos(tilt));
  close_to(last.moved.x, speed * speed / 2 / a, 1e-9, "way");
  close_to(find_event(&h, TP_EVENT_RESTS, 0)->time_s, speed / a, 1e-9, "time");
  tp_history_clear(&h);
  body_stage_clear(&s);
}
END_TEST

/* A disc of four arcs on a slope of which one edge of the base is 40 m long. */
typedef struct disc {
  tp_edge outline[4], base[4];
  double friction[4];
  tp_rigid_body body;
} disc;

static void disc_init(disc *d, double radius, double friction) {
  const tp_xy corners[4] = {{20, -radius}, {-20, -radius}, {-20, -9}, {20, -9}};
  const tp_xy ring[4] = {{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}};
  for (int k = 0; k < 4; k++) {
    d->outline[k] = (tp_edge){
        .from = ring[k], .to = ring[(k + 1) % 4], .arc = true, .radius = radius, .number = k + 1};
    d->base[k] = (tp_edge){.from = corners[k], .to = corners[(k + 1) % 4], .number = k == 0};
    d->friction[k] = friction;
  }
  d->body = (tp_rigid_body){.outline = {4, d->outline},
                            .base = {4, d->base},
                            .friction = d->friction,
                            .mass_kg = 7,
                            .inertia_kg_m2 = 7 * radius * radius / 2,
                            .thickness_m = 1,
                            .extent_m = radius,
                            .towards = TP_TOWARDS_LEFT};
}

/* Rolling: 2/3 g sin(tilt) where friction is a third of the slope at least; less of it slips, and
 * spins the disc up by friction alone. */
START_TEST(disc_rolls_and_slips_down_a_slope) {
  const double tilt = 0.5, radius = 0.8, seconds = 2;
  for (int k = 0; k < 2; k++) {
    disc d;
    tp_body_state last;
    const tp_body_state start = {0};
    const tp_drive drive = {.angle = tilt};
    const double friction = (k == 0 ? 0.4 : 0.2) * tan(tilt);
    disc_init(&d, radius, friction);
    ck_assert_int_eq(run_for(NULL, &last, &d.body, &drive, &start, seconds, 0, bounce),
                     TP_RUN_OVERTURNED);
    const double g = TP_GRAVITY_M_S2,
                 along = k == 0 ? 2 * g * sin(tilt) / 3 : g * (sin(tilt) - friction * cos(tilt));
    const double spin = k == 0 ? along / radius : 2 * friction * g * cos(tilt) / radius;
    close_to(-last.speed.x, along * seconds, 1e-9, "speed");
    close_to(last.turning, spin * seconds, 1e-9, "spin");
    close_to(-last.moved.x, along * seconds * seconds / 2, 1e-9, "way");
    ck_assert(fabs(last.moved.y) < 1e-10);
  }
}
END_TEST

/* A disc that falls and bounces with e rests after sqrt(2 h / g) (1 + e) / (1 - e), but for the
 * time of the bounces no higher than 1e-9 of it, which are passed and said. */
START_TEST(bounces_without_end_are_passed_at_their_time) {
  const double fall = 0.7, e = 0.5, radius = 1;
  disc d;
  tp_history h = {0};
  tp_body_state last;
  const tp_body_state start = {.moved = {0, fall}};
  disc_init(&d, radius, 0.3);
  ck_assert_int_eq(run_for(&h, &last, &d.body, &level, &start, 100, e, bounce), TP_RUN_RESTS);
  const double first = sqrt(2 * fall / TP_GRAVITY_M_S2), end = first * (1 + e) / (1 - e);
  const double passed = 2 * sqrt(2 * 1e-9 * radius / TP_GRAVITY_M_S2) / (1 - e);
  const double rests = find_event(&h, TP_EVENT_RESTS, 0)->time_s;
  ck_assert_msg(rests <= end && rests >= end - passed, "rests at %.9g, not %.9g", rests, end);
  ck_assert_double_eq(find_event(&h, TP_EVENT_ACCUMULATES, 0)->time_s, rests);
  for (size_t k = 0; k < 10; k++) {
    /* each may begin 1e-11 of the radius deep, and end as deep */
    const double energy = fall * TP_GRAVITY_M_S2 * pow(e, 2.0 * (double)k);
    const double speed = find_event(&h, TP_EVENT_CLOSES, k)->speed_m_s;
    ck_assert(fabs(speed * speed / 2 - energy) < 3e-11 * TP_GRAVITY_M_S2 * radius);
  }
  ck_assert(fabs(last.moved.y) < 1e-10);
  tp_history_clear(&h);
}
END_TEST

SUITE(rigid_contact) {
  Suite *suite = suite_create("rigid contact");
  TCase *tests = tcase_create("closed forms");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, extrapolation_goes_where_a_runge_kutta_method_does);
  tcase_add_test(tests, quarter_of_a_period_is_that_of_the_quadrature);
  tcase_add_test(tests, slender_block_has_housners_period);
  tcase_add_test(tests, rocking_dies_out_by_the_restitution_of_angular_momentum);
  tcase_add_test(tests, least_pulse_that_overturns_is_that_of_the_one_equation);
  tcase_add_test(tests, slab_slides_as_a_point_does);
  tcase_add_test(tests, slab_thrown_up_a_slope_stops_after_the_way_of_its_energy);
  tcase_add_test(tests, disc_rolls_and_slips_down_a_slope);
  tcase_add_test(tests, bounces_without_end_are_passed_at_their_time);
  suite_add_tcase(suite, tests);
  return suite;
}
