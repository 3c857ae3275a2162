/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Anchors, by the squares of their components; which loads a scene has; and which are on the block,
 * against the triangles of a star about its centre. */

#include "load/check.h"
#include "load_stage.h"
#include "random_numbers.h"
#include "suite.h"

#include <string.h>

static random_numbers state;

static void anchor_init(tp_anchor_description *a) {
  memset(a, 0, sizeof *a);
  fmpq_init(a->x.value);
  fmpq_init(a->y.value);
  fmpq_init(a->direction_deg.value);
  fmpq_init(a->force_kn.value);
  fmpq_init(a->step_x.value);
  fmpq_init(a->step_y.value);
  a->force_kn.given = true;
}

static void anchor_clear(tp_anchor_description *a) {
  fmpq_clear(a->x.value);
  fmpq_clear(a->y.value);
  fmpq_clear(a->direction_deg.value);
  fmpq_clear(a->force_kn.value);
  fmpq_clear(a->step_x.value);
  fmpq_clear(a->step_y.value);
}

/* A component's square is F^2 times so many quarters, to all but 8 bits, and it has that sign. */
static void check_component(const arb_t force, const fmpq_t force_kn, long quarters, int sign) {
  fmpq_t square;
  arb_t own;
  fmpq_init(square);
  arb_init(own);
  fmpq_mul(square, force_kn, force_kn);
  fmpq_mul_si(square, square, 250000 * quarters); /* kN^2 / 4 in N^2 */
  arb_mul(own, force, force, STAGE_BITS);
  ck_assert(arb_contains_fmpq(own, square));
  ck_assert_int_gt(arb_rel_accuracy_bits(own), STAGE_BITS - 8);
  ck_assert_int_eq(arf_sgn(arb_midref(force)), sign);
  fmpq_clear(square);
  arb_clear(own);
}

/* M = x F_y - y F_x of what the wrench says of F. */
static void check_moment(const load_stage *s, const tp_anchor_description *a) {
  fmpq_t metres;
  arb_t moment, arm;
  fmpq_init(metres);
  arb_init(moment);
  arb_init(arm);
  fmpq_mul(metres, a->x.value, s->scene.metres_per_unit);
  if (s->setting.mirrored) fmpq_neg(metres, metres);
  arb_set_fmpq(arm, metres, STAGE_BITS);
  arb_mul(moment, arm, s->wrench.y.of + TP_ONE, STAGE_BITS);
  fmpq_mul(metres, a->y.value, s->scene.metres_per_unit);
  arb_set_fmpq(arm, metres, STAGE_BITS);
  arb_submul(moment, arm, s->wrench.x.of + TP_ONE, STAGE_BITS);
  ck_assert(arb_overlaps(moment, s->wrench.moment.of + TP_ONE));
  fmpq_clear(metres);
  arb_clear(moment);
  arb_clear(arm);
}

/* An anchor pulls as it is told to in the block's frame, whatever the tilt. Directions are those
 * whose cosine has a square of whole quarters. */
START_TEST(anchor_pulls_in_its_direction) {
  static const struct {
    long degrees, quarters;
    int right, up;
  } directions[] = {{0, 4, 1, 0},    {30, 3, 1, 1},   {45, 2, 1, 1},     {60, 1, 1, 1},
                    {90, 0, 0, 1},   {120, 1, -1, 1}, {150, 3, -1, 1},   {180, 4, -1, 0},
                    {270, 0, 0, -1}, {-30, 3, 1, -1}, {-135, 2, -1, -1}, {300, 1, 1, -1}};
  enum { DIRECTIONS = sizeof directions / sizeof directions[0] };
  for (int round = 0; round < 50 * DIRECTIONS; round++) {
    const int k = round % DIRECTIONS;
    load_stage s;
    tp_anchor_description a;
    load_stage_init(&s, &state);
    anchor_init(&a);
    load_stage_draw(&s, &a.x, -40, 40);
    load_stage_draw(&s, &a.y, -40, 40);
    load_stage_draw(&s, &a.force_kn, 1, 500);
    fmpq_set_si(a.direction_deg.value, directions[k].degrees, 1);
    tp_load_anchor(&s.wrench, &a, 0, &s.setting);
    check_component(s.wrench.x.of + TP_ONE, a.force_kn.value, directions[k].quarters,
                    s.setting.mirrored ? -directions[k].right : directions[k].right);
    check_component(s.wrench.y.of + TP_ONE, a.force_kn.value, 4 - directions[k].quarters,
                    directions[k].up);
    check_moment(&s, &a);
    for (int term = 0; term < TP_BASIS; term++) {
      if (term == TP_ONE) continue;
      ck_assert(arb_is_zero(s.wrench.x.of + term));
      ck_assert(arb_is_zero(s.wrench.y.of + term));
      ck_assert(arb_is_zero(s.wrench.moment.of + term));
    }
    anchor_clear(&a);
    load_stage_clear(&s);
  }
}
END_TEST

enum { LINES = 3, ANCHORS = 2, MOST_LOADS = 9 };

/* Bits of `named`: seismic, water, uplift, pressures, surcharge, anchors. */
static void name_loads(tp_loads_description *d, unsigned named) {
  d->horizontal.given = (named & 3) == 1;
  d->vertical.given = (named & 3) == 3;
  d->water.given = (named & 2) != 0;
  d->water.uplift = (named & 4) != 0;
  d->pressure_count = (named & 8) != 0 ? 2 : 0;
  d->surcharge_count = (named & 16) != 0;
  d->anchor_count = (named & 32) != 0 ? ANCHORS : 0;
}

/* A scene has the loads that it names, in their order, and an anchor is on the side that it says.
 * Bond and cohesion are called for, and are no loads. */
START_TEST(loads_are_those_that_are_named) {
  static const struct {
    tp_load_kind kind;
    unsigned calls; /* bits of `named` that must all be set */
  } order[MOST_LOADS] = {{TP_LOAD_WEIGHT, 0},     {TP_LOAD_SEISMIC, 1},  {TP_LOAD_WATER, 2},
                         {TP_LOAD_UPLIFT, 2 | 4}, {TP_LOAD_PRESSURE, 8}, {TP_LOAD_PRESSURE, 8},
                         {TP_LOAD_SURCHARGE, 16}, {TP_LOAD_ANCHOR, 32},  {TP_LOAD_ANCHOR, 32}};
  load_stage s;
  stage_line lines[LINES];
  tp_line_load own[LINES];
  tp_anchor_description anchors[ANCHORS];
  load_stage_init(&s, &state);
  for (int k = 0; k < LINES; k++) {
    stage_line_init(lines + k, &s);
    own[k] = lines[k].load;
  }
  for (int k = 0; k < ANCHORS; k++) anchor_init(anchors + k);
  anchors[1].passive = true;
  tp_loads_description *d = &s.scene.loads;
  d->pressures = own;
  d->surcharges = own + 2;
  d->anchors = anchors;
  for (unsigned named = 0; named < 64; named++) {
    tp_load loads[MOST_LOADS];
    memset(loads, 0, sizeof loads);
    for (int k = 0; k < MOST_LOADS; k++) tp_wrench_init(&loads[k].wrench);
    name_loads(d, named);
    tp_loads_evaluate(loads, &s.setting);
    long count = 0;
    for (int k = 0; k < MOST_LOADS; k++) {
      if ((named & order[k].calls) != order[k].calls) continue;
      ck_assert_int_eq(loads[count].kind, order[k].kind);
      ck_assert_int_eq(loads[count].active, k == 7);
      ck_assert_int_eq(loads[count].passive, k == 8);
      count++;
    }
    ck_assert_int_eq(tp_loads_count(d), count);
    d->bond_kpa.given = d->cohesion_kpa.given = false;
    ck_assert_int_eq(tp_loads_are_called_for(d), count > 1);
    *(named % 2 == 0 ? &d->bond_kpa.given : &d->cohesion_kpa.given) = true;
    ck_assert(tp_loads_are_called_for(d));
    ck_assert_int_eq(tp_loads_count(d), count);
    for (int k = 0; k < MOST_LOADS; k++) tp_wrench_clear(&loads[k].wrench);
  }
  for (int k = 0; k < LINES; k++) stage_line_clear(lines + k);
  for (int k = 0; k < ANCHORS; k++) anchor_clear(anchors + k);
  load_stage_clear(&s);
}
END_TEST

/* ---- on the block -------------------------------------------------------------------------------
 */

enum { STAR = 6 };

/* A star about (0, 0) of points on a small grid, counter-clockwise: one in each of six sectors. */
typedef struct star {
  tp_polyline ring;
  long x[STAR], y[STAR];
} star;

static long turn(long ax, long ay, long bx, long by) {
  return ax * by - ay * bx;
}

static void star_init(star *s) {
  static const long rays[STAR][2] = {{1, 0}, {1, 1}, {-1, 2}, {-1, 0}, {-1, -1}, {1, -2}};
  memset(s, 0, sizeof *s);
  for (int k = 0; k < STAR; k++) {
    const long far = 1 + draw_below(&state, 3);
    s->x[k] = far * rays[k][0];
    s->y[k] = far * rays[k][1];
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    fmpq_set_si(x, s->x[k], 1);
    fmpq_set_si(y, s->y[k], 1);
    ck_assert(tp_polyline_append(&s->ring, x, y, (tp_mark){0}));
    fmpq_clear(x);
    fmpq_clear(y);
  }
}

/* In one of its triangles, their sides included: in halves of the grid. */
static bool star_holds(const star *s, long x, long y) {
  for (int k = 0; k < STAR; k++) {
    const long ax = 2 * s->x[k], ay = 2 * s->y[k];
    const long bx = 2 * s->x[(k + 1) % STAR], by = 2 * s->y[(k + 1) % STAR];
    if (turn(ax, ay, x, y) >= 0 && turn(x, y, bx, by) >= 0 &&
        turn(bx - ax, by - ay, x - ax, y - ay) >= 0) {
      return true;
    }
  }
  return false;
}

/* An anchor holds the block where it lies in the outline or on it. */
START_TEST(anchors_are_in_the_outline) {
  long inside = 0, outside = 0;
  for (int round = 0; round < 300; round++) {
    star s;
    tp_anchor_description a;
    star_init(&s);
    anchor_init(&a);
    tp_scene scene = {.loads = {.anchor_count = 1, .anchors = &a}};
    const tp_section section = {.ring_count = 1, .rings = &s.ring};
    for (long x = -7; x <= 7; x++) {
      for (long y = -13; y <= 13; y++) {
        tp_message message = {.text = ""};
        fmpq_set_si(a.x.value, x, 2);
        fmpq_set_si(a.y.value, y, 2);
        const bool truth = star_holds(&s, x, y);
        ck_assert_int_eq(tp_loads_check(&scene, &section, &message), truth ? TP_OK : TP_BAD_INPUT);
        (*(truth ? &inside : &outside))++;
      }
    }
    anchor_clear(&a);
    tp_polyline_clear(&s.ring);
  }
  ck_assert_int_gt(inside, 10000);
  ck_assert_int_gt(outside, 10000);
}
END_TEST

/* A pressure pushes where it runs along an edge of the outline counter-clockwise; a surcharge may
 * run either way; neither acts beside an edge or past its end. */
START_TEST(lines_are_on_an_edge) {
  static const long shares[][2] = {{0, 8}, {1, 5},  {8, 0},
                                   {6, 2}, {-1, 4}, {3, 9}}; /* in eighths */
  star s;
  load_stage stage;
  stage_line line;
  load_stage_init(&stage, &state);
  stage_line_init(&line, &stage);
  tp_line_load *load = &line.load;
  star_init(&s);
  const tp_section section = {.ring_count = 1, .rings = &s.ring};
  for (int k = 0; k < STAR * 6 * 4; k++) {
    const long *share = shares[k / STAR % 6], edge = k % STAR, next = (edge + 1) % STAR;
    const bool pressure = k / STAR / 6 % 2 == 0, beside = k / STAR / 12 == 1;
    fmpq *const ends[2][2] = {{load->x0.value, load->y0.value}, {load->x1.value, load->y1.value}};
    for (int end = 0; end < 2; end++) {
      fmpq_set_si(ends[end][0], (8 - share[end]) * s.x[edge] + share[end] * s.x[next], 8);
      fmpq_set_si(ends[end][1], (8 - share[end]) * s.y[edge] + share[end] * s.y[next], 8);
    }
    if (beside) fmpq_mul_si(load->x1.value, load->x1.value, 100);
    if (beside) fmpq_add_si(load->y1.value, load->y1.value, 100);
    tp_scene scene = {.loads = {.pressure_count = pressure, .surcharge_count = !pressure}};
    scene.loads.pressures = scene.loads.surcharges = load;
    tp_message message = {.text = ""};
    const bool past = share[0] < 0 || share[1] > 8, backwards = share[0] > share[1];
    const bool fails = past || beside || (pressure && backwards);
    ck_assert_int_eq(tp_loads_check(&scene, &section, &message), fails ? TP_BAD_INPUT : TP_OK);
    if (!fails) continue;
    ck_assert_ptr_nonnull(
        strstr(message.text, past || beside ? "does not act on an edge" : "would pull"));
  }
  tp_polyline_clear(&s.ring);
  stage_line_clear(&line);
  load_stage_clear(&stage);
}
END_TEST

SUITE(load_scene) {
  state = random_numbers_from(52);
  Suite *suite = suite_create("load_scene");
  TCase *cases = tcase_create("load_scene");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, anchor_pulls_in_its_direction);
  tcase_add_test(cases, loads_are_those_that_are_named);
  tcase_add_test(cases, anchors_are_in_the_outline);
  tcase_add_test(cases, lines_are_on_an_edge);
  suite_add_tcase(suite, cases);
  return suite;
}
