/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Runs of rigid contact as a caller has them: a half disc that rocks against quadrature, what
 * history decides, what ends a run, and blocks drawn at random that tumble down rough slopes. */

#include "body_stage.h"
#include "random_numbers.h"
#include "rigid_contact/rigid_contact.h"
#include "suite.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <string.h>

static const double pi = 3.141592653589793;

/* ---- a half disc ---- */

enum { MOST_EDGES = 64 };

typedef struct made_body {
  tp_edge outline[MOST_EDGES], base[MOST_EDGES];
  double friction[MOST_EDGES];
  tp_rigid_body body;
} made_body;

static void set_ring(tp_boundary *ring, tp_edge *edges, const tp_xy *points, long count) {
  for (long k = 0; k < count; k++) {
    edges[k] = (tp_edge){.from = points[k], .to = points[(k + 1) % count], .number = k + 1};
  }
  *ring = (tp_boundary){count, edges};
}

/* Of radius 1 m, flat on top, on a level base; its centroid 4 / (3 pi) below its centre. */
static void half_disc(made_body *own) {
  const double off = 4 / (3 * pi);
  const tp_xy ring[3] = {{1, off}, {-1, off}, {0, off - 1}};
  const tp_xy base[4] = {{9, off - 1}, {-9, off - 1}, {-9, -5}, {9, -5}};
  memset(own, 0, sizeof *own);
  set_ring(&own->body.outline, own->outline, ring, 3);
  set_ring(&own->body.base, own->base, base, 4);
  for (int k = 1; k < 3; k++) {
    own->outline[k].arc = true;
    own->outline[k].radius = 1;
    own->outline[k].centre = (tp_xy){0, off};
  }
  for (int k = 0; k < 4; k++) own->friction[k] = 1;
  own->body.friction = own->friction;
  own->body.mass_kg = 3;
  own->body.inertia_kg_m2 = 3 * (0.5 - off * off);
  own->body.extent_m = hypot(1, off);
}

/* Its energy is (k^2 + 1 + e^2 - 2 e cos x) x'^2 / 2 - g e cos x. */
static double half_disc_rate(double s, void *context) {
  const double most = *(const double *)context, e = 4 / (3 * pi), k2 = 0.5 - e * e;
  const double b = s * s, x = most - b, part = b == 0 ? 0.5 : sin(b / 2) / b;
  const double inertia = k2 + 1 + e * e - 2 * e * cos(x);
  return 2 * sqrt(inertia / (4 * TP_GRAVITY_M_S2 * e * sin(most - b / 2) * part));
}

START_TEST(half_disc_rocks_on_its_arc) {
  made_body own;
  double amplitude = 1, quarter, error;
  half_disc(&own);
  const gsl_function f = {half_disc_rate, &amplitude};
  gsl_integration_workspace *work = gsl_integration_workspace_alloc(100);
  ck_assert_int_eq(
      gsl_integration_qag(&f, 0, 1, 0, 1e-13, 100, GSL_INTEG_GAUSS61, work, &quarter, &error), 0);
  gsl_integration_workspace_free(work);
  /* it has rolled by its turn, its centre as high as before */
  const double e = 4 / (3 * pi);
  const tp_drive drive = {0};
  const tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  for (int half = 0; half < 2; half++) {
    tp_body_state last;
    tp_rigid_contact_account account;
    tp_message message = {.text = ""};
    const tp_run run = {
        .body = &own.body,
        .drive = &drive,
        .start = {.moved = {-amplitude + e * sin(amplitude), e - e * cos(amplitude)},
                  .turned = amplitude},
        .longest_s = (half + 1) * quarter};
    ck_assert_int_eq(tp_rigid_contact_run(&last, &account, &run, &settings, &message),
                     TP_RUN_MOVES);
    ck_assert(account.worst_balance < 1e-12);
    const double expected = half == 0 ? 0 : -amplitude;
    ck_assert_msg(fabs(last.turned - expected) < 1e-10, "turned %.17g", last.turned);
    ck_assert(fabs(last.moved.x + expected - e * sin(expected)) < 1e-10);
    if (half == 1) ck_assert(fabs(last.turning) < 1e-9);
  }
}
END_TEST

/* ---- what history decides ---- */

#define WINDOW                                                                                     \
  "topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 1.123], [0.588, 0.901], [1.536, -0.465], "   \
  "[0.967, 4.599], [-0.569, 4.599]]\nbase: {profile: [[0, 1.123], [0.588, 0.901], [1.536, "        \
  "-0.465]]}\nfriction_angle_deg: 61.36\ntilt: {towards: left}\n"

/* Between 19.453 and 25.091 degrees forces could hold this block, which nothing has put there
 * (mechanics.md section 6a). */
START_TEST(between_both_limits_history_decides) {
  static const struct {
    double angle_deg;
    tp_window_rule rule;
    bool moves, in_window;
  } cases[] = {{19.4, TP_WINDOW_MOVES, false, false},  {19.5, TP_WINDOW_MOVES, true, true},
               {25.0, TP_WINDOW_MOVES, true, true},    {25.1, TP_WINDOW_MOVES, true, false},
               {19.5, TP_WINDOW_STANDS, false, false}, {25.0, TP_WINDOW_STANDS, false, false},
               {25.1, TP_WINDOW_STANDS, true, false}};
  body_stage s;
  body_stage_init(&s, WINDOW, TP_TOWARDS_LEFT);
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    tp_rigid_contact_account account;
    tp_message message = {.text = ""};
    tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
    settings.window = cases[k].rule;
    const tp_drive drive = {.angle = cases[k].angle_deg * pi / 180};
    const tp_run run = {.body = &s.body, .drive = &drive, .longest_s = 1, .until_collapse = true};
    ck_assert_int_eq(tp_rigid_contact_run(NULL, &account, &run, &settings, &message),
                     cases[k].moves ? TP_RUN_MOVES : TP_RUN_STANDS);
    ck_assert(account.in_window == cases[k].in_window);
  }
  body_stage_clear(&s);
}
END_TEST

/* ---- what ends a run ---- */

static bool stop_at_once(void *context) {
  ++*(int *)context;
  return true;
}

static void check_undecided(const tp_rigid_contact_settings *settings, bool stops,
                            const char *says) {
  made_body own;
  int asked = 0;
  half_disc(&own);
  tp_message message = {.text = ""};
  const tp_drive drive = {0};
  const tp_run run = {.body = &own.body,
                      .drive = &drive,
                      .start = {.moved = {0, 1}, .turned = 0.5},
                      .longest_s = 100,
                      .stop = stops ? stop_at_once : NULL,
                      .context = &asked};
  const tp_run_end end = tp_rigid_contact_run(NULL, NULL, &run, settings, &message);
  ck_assert_msg(end == TP_RUN_UNDECIDED, "it ends by %d, where %s", end, says);
  ck_assert_msg(strstr(message.text, says) != NULL, "%s", message.text);
  ck_assert_int_eq(asked, stops);
}

START_TEST(runs_end_by_their_bounds_and_say_so) {
  tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  check_undecided(&settings, true, "it was stopped");
  settings.most_steps = 10;
  check_undecided(&settings, false, "it took the most steps");
  settings = tp_rigid_contact_settings_default();
  settings.restitution = 0.9;
  settings.most_events = 3;
  check_undecided(&settings, false, "it met the most events");
}
END_TEST

/* ---- blocks at random ---- */

static double between(random_numbers *numbers, double low, double high) {
  return low + (high - low) * draw_part(numbers);
}

/* A convex block with corners on a circle of 1 m, above a rough base. */
static void draw_body(made_body *own, random_numbers *numbers) {
  enum { FACETS = 30 };
  tp_xy ring[8], base[FACETS + 3];
  const long corners = 3 + draw_below(numbers, 5);
  double area = 0, x = 0, y = 0, second = 0;
  memset(own, 0, sizeof *own);
  for (long k = 0; k < corners; k++) {
    const double turn = 2 * pi * ((double)k + 0.8 * draw_part(numbers)) / (double)corners;
    ring[k] = (tp_xy){cos(turn), sin(turn)};
  }
  for (long k = 0; k < corners; k++) {
    const tp_xy p = ring[k], q = ring[(k + 1) % corners];
    const double c = p.x * q.y - p.y * q.x;
    area += c / 2;
    x += (p.x + q.x) * c / 6;
    y += (p.y + q.y) * c / 6;
    second += (p.x * p.x + p.x * q.x + q.x * q.x + p.y * p.y + p.y * q.y + q.y * q.y) * c / 12;
  }
  for (long k = 0; k < corners; k++) {
    ring[k].x -= x / area;
    ring[k].y -= y / area;
    own->body.extent_m = fmax(own->body.extent_m, hypot(ring[k].x, ring[k].y));
  }
  for (int k = 0; k <= FACETS; k++) {
    base[k] = (tp_xy){15 - k, -2 - between(numbers, 0, 0.5)};
  }
  base[FACETS + 1] = (tp_xy){-15, -5};
  base[FACETS + 2] = (tp_xy){15, -5};
  set_ring(&own->body.outline, own->outline, ring, corners);
  set_ring(&own->body.base, own->base, base, FACETS + 3);
  const double friction = between(numbers, 0, 1.2);
  for (int k = 0; k < FACETS + 3; k++) own->friction[k] = friction;
  own->body.friction = own->friction;
  own->body.mass_kg = area;
  own->body.inertia_kg_m2 = second - (x * x + y * y) / area;
}

/* Whatever they do, each ends in some way, and its energy is accounted for. */
START_TEST(blocks_tumble_down_rough_slopes) {
  enum { BLOCKS = 150 };
  random_numbers numbers = random_numbers_from(1818);
  int ends[TP_RUN_NO_MEMORY + 1] = {0};
  for (int k = 0; k < BLOCKS; k++) {
    made_body own;
    tp_rigid_contact_account account;
    tp_message message = {.text = ""};
    tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
    settings.restitution = k % 2 == 0 ? 0 : between(&numbers, 0, 0.8);
    draw_body(&own, &numbers);
    const tp_drive drive = {.angle = between(&numbers, 0, 0.8)};
    const tp_run run = {.body = &own.body,
                        .drive = &drive,
                        .start = {.turned = between(&numbers, -3, 3),
                                  .speed = {between(&numbers, -1, 1), 0},
                                  .turning = between(&numbers, -2, 2)},
                        .longest_s = 5};
    const tp_run_end end = tp_rigid_contact_run(NULL, &account, &run, &settings, &message);
    ck_assert_msg(end < TP_RUN_UNDECIDED, "block %d: %s", k, message.text);
    ck_assert_msg(account.worst_balance < 1e-9, "block %d: energy off by %g", k,
                  account.worst_balance);
    ends[end]++;
  }
  ck_assert(ends[TP_RUN_RESTS] > 10 && ends[TP_RUN_LEFT_BASE] + ends[TP_RUN_OVERTURNED] > 10);
}
END_TEST

SUITE(rigid_contact_runs) {
  Suite *suite = suite_create("runs of rigid contact");
  TCase *tests = tcase_create("runs");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, half_disc_rocks_on_its_arc);
  tcase_add_test(tests, between_both_limits_history_decides);
  tcase_add_test(tests, runs_end_by_their_bounds_and_say_so);
  tcase_add_test(tests, blocks_tumble_down_rough_slopes);
  suite_add_tcase(suite, tests);
  return suite;
}
