/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Filters in doubles with bounds against exact numbers: what they tell is so, and they tell most of
 * what is asked. Contacts, loads and frictions are binary fractions, whose balls are exact. */

#include "certificate/filter.h"
#include "motion/bounds.h"
#include "motion/strata.h"
#include "motion/tilt_side.h"
#include "random_numbers.h"
#include "suite.h"
#include "whole_vectors.h"

#include <arb.h>
#include <flint/fmpq.h>
#include <math.h>

enum { CONTACTS = 4000, MOST = 6, EXACT = ARF_PREC_EXACT };

static const tp_judge exact_judge = {.bits = 128, .precision = EXACT};

static random_numbers state;

/* From -reach to reach, in parts. */
static void draw_fraction(arb_t number, long reach, long log2_parts) {
  const long parts = 1L << log2_parts;
  arb_set_si(number, draw_below(&state, 2 * reach * parts + 1) - reach * parts);
  arb_mul_2exp_si(number, number, -log2_parts);
}

static void draw_contact(tp_cones *cones) {
  const long count = 1 + draw_below(&state, MOST), spread = 2 + draw_below(&state, 4);
  ck_assert(tp_cones_init(cones, count));
  for (long k = 0; k < count; k++) {
    const long tx = 1 + draw_below(&state, spread);
    set_point(cones, k, draw_below(&state, 4 * spread), draw_below(&state, spread), tx,
              draw_below(&state, 2 * spread + 1) - spread);
  }
  arb_set_si(cones->friction, draw_below(&state, 9));
  arb_mul_2exp_si(cones->friction, cones->friction, -3);
}

/* ---- motion/mode_filter.h -------------------------------------------------------------------- */

/* Weight, or weight and an earthquake off the centroid. */
static void draw_question(tp_motion_question *q, const tp_cones *cones) {
  tp_motion_question_init(q, cones);
  q->judge = exact_judge;
  arb_one(q->scale);
  draw_fraction(q->x, 8, 2);
  draw_fraction(q->y, 8, 2);
  arb_set_si(q->gyration, 1 + draw_below(&state, 30));
  arb_set_si(q->load.x.of + TP_SIN, -1);
  arb_set_si(q->load.y.of + TP_COS, -1);
  q->through_centroid = draw_below(&state, 2) == 0;
  if (q->through_centroid) return;
  draw_fraction(q->load.x.of + TP_COS, 1, 3);
  arb_neg(q->load.y.of + TP_SIN, q->load.x.of + TP_COS);
  draw_fraction(q->load.moment.of + TP_COS, 2, 3);
  draw_fraction(q->load.moment.of + TP_SIN, 2, 3);
}

static void work(fmpq_t sum, const tp_vector *h, const tp_motion_question *q, int basis) {
  const tp_trig *load[] = {&q->load.x, &q->load.y, &q->load.moment};
  arb_t own;
  arb_init(own);
  for (int row = 0; row < 3; row++) {
    arb_addmul(own, h->of + row, load[row]->of + basis, EXACT);
  }
  ck_assert(arb_is_exact(own));
  arf_get_fmpq(sum, arb_midref(own));
  arb_clear(own);
}

/* The tangents that all planes leave. */
typedef struct span {
  bool empty, has[2]; /* by `lower` */
  fmpq_t of[2];
} span;

static void narrow(span *s, const tp_vector *h, const tp_motion_question *q) {
  fmpq_t level, rise;
  fmpq_init(level);
  fmpq_init(rise);
  work(level, h, q, TP_COS);
  work(rise, h, q, TP_SIN);
  const int sign = fmpq_sgn(rise), lower = sign > 0;
  if (sign == 0) {
    s->empty = s->empty || fmpq_sgn(level) < 0;
  } else {
    fmpq_div(level, level, rise);
    fmpq_neg(level, level);
    const int order = s->has[lower] ? fmpq_cmp(level, s->of[lower]) : 0;
    if (!s->has[lower] || (lower ? order > 0 : order < 0)) fmpq_set(s->of[lower], level);
    s->has[lower] = true;
  }
  fmpq_clear(level);
  fmpq_clear(rise);
}

static void span_init(span *s) {
  *s = (span){.empty = false};
  fmpq_init(s->of[0]);
  fmpq_init(s->of[1]);
}

static void span_clear(span *s) {
  fmpq_clear(s->of[0]);
  fmpq_clear(s->of[1]);
}

/* Both routes of one question. */
typedef struct comparing {
  const tp_motion_question *q;
  const tp_normals *n;
  const tp_twists *twists;
  tp_mode_filter filter, none;
  tp_bounds doubles, balls;
  long told[3]; /* by tp_mode_tilts */
} comparing;

static void compare_ends(comparing *c, const tp_mode *mode, const span *truth) {
  span chosen;
  span_init(&chosen);
  ck_assert(!truth->empty);
  for (long k = 0; k < c->doubles.count; k++) {
    ck_assert_int_eq(tp_bounds_evaluate(&c->doubles, k, c->q, c->n, c->twists, mode),
                     TP_MOTION_PROVEN);
    const bool lower = c->doubles.items[k].lower;
    span own;
    span_init(&own);
    narrow(&own, &c->doubles.items[k].h, c->q);
    ck_assert(own.has[lower] && !own.has[!lower]);
    ck_assert(fmpq_equal(own.of[lower], truth->of[lower]));
    chosen.has[lower] = true;
    span_clear(&own);
  }
  ck_assert(chosen.has[0] == truth->has[0] && chosen.has[1] == truth->has[1]);
  span_clear(&chosen);
}

static tp_motion_outcome compare_mode(void *context, const tp_mode *mode) {
  comparing *c = context;
  ck_assert_int_eq(tp_bounds_find(&c->doubles, &c->filter, c->q, c->n, c->twists, mode, NULL),
                   TP_MOTION_PROVEN);
  ck_assert_int_eq(tp_bounds_find(&c->balls, &c->none, c->q, c->n, c->twists, mode, NULL),
                   TP_MOTION_PROVEN);
  ck_assert_int_eq(c->balls.tilts, TP_TILTS_OPEN);
  span truth;
  span_init(&truth);
  for (long k = 0; k < c->balls.count; k++) narrow(&truth, &c->balls.items[k].h, c->q);
  if (truth.has[0] && truth.has[1] && fmpq_cmp(truth.of[1], truth.of[0]) > 0) truth.empty = true;
  c->told[c->doubles.tilts]++;
  if (c->doubles.tilts == TP_TILTS_NONE) ck_assert(truth.empty);
  if (c->doubles.tilts == TP_TILTS_BETWEEN) compare_ends(c, mode, &truth);
  span_clear(&truth);
  return TP_MOTION_PROVEN;
}

START_TEST(tilts_of_modes_are_those_of_balls) {
  state = random_numbers_from(20261124);
  long told[3] = {0};
  for (long k = 0; k < CONTACTS; k++) {
    tp_cones cones;
    tp_motion_question q;
    tp_normals normals;
    tp_twists twists;
    draw_contact(&cones);
    draw_question(&q, &cones);
    ck_assert_int_eq(tp_normals_init(&normals, &cones, &q.judge), TP_MOTION_PROVEN);
    ck_assert_int_eq(tp_twists_init(&twists, &normals, NULL), TP_MOTION_PROVEN);
    comparing c = {.q = &q, .n = &normals, .twists = &twists};
    tp_mode_filter_init(&c.filter, &q);
    ck_assert(c.filter.applies);
    ck_assert_int_eq(tp_strata_visit(&twists, &normals, false, compare_mode, &c), TP_MOTION_PROVEN);
    for (int t = 0; t < 3; t++) told[t] += c.told[t];
    tp_bounds_clear(&c.doubles);
    tp_bounds_clear(&c.balls);
    tp_twists_clear(&twists);
    tp_normals_clear(&normals);
    tp_motion_question_clear(&q);
    tp_cones_clear(&cones);
  }
  printf("modes: %ld open, %ld at no tilt, %ld between tilts\n", told[TP_TILTS_OPEN],
         told[TP_TILTS_NONE], told[TP_TILTS_BETWEEN]);
  ck_assert_int_gt(told[TP_TILTS_NONE], CONTACTS / 2);
  ck_assert_int_gt(told[TP_TILTS_BETWEEN], CONTACTS / 2);
}
END_TEST

/* ---- certificate/filter.h -------------------------------------------------------------------- */

/* Some twists, and those of the face of two columns, to which both are exactly normal. */
static void draw_twist(tp_vector *twist, const tp_cones *cones) {
  tp_vector sides[2];
  for (int s = 0; s < 2; s++) {
    tp_vector_init(sides + s);
    tp_cones_column(sides[s].of, cones, draw_below(&state, 2 * cones->count), EXACT);
  }
  tp_vector_cross(twist, sides, sides + 1, EXACT);
  if (draw_below(&state, 2) == 0) {
    for (int row = 0; row < 3; row++) draw_fraction(twist->of + row, 40, 20);
  }
  for (int s = 0; s < 2; s++) tp_vector_clear(sides + s);
}

/* A contact of any size, far from its origin or about it. */
static void move(tp_cones *cones) {
  const long exponent = draw_below(&state, 81) - 40, shift = draw_below(&state, 40);
  for (long k = 0; k < cones->count; k++) {
    const arb_struct own[] = {tp_cones_x(cones, k), tp_cones_y(cones, k)};
    arb_t at[2];
    for (int e = 0; e < 2; e++) {
      arb_init(at[e]);
      fmpz_t away;
      fmpz_init_set_si(away, 1);
      fmpz_mul_2exp(away, away, (ulong)shift);
      arb_add_fmpz(at[e], own + e, away, EXACT);
      arb_mul_2exp_si(at[e], at[e], exponent);
      fmpz_clear(away);
    }
    tp_cones_set_place(cones, k, at[0], at[1]);
    for (int e = 0; e < 2; e++) arb_clear(at[e]);
  }
}

START_TEST(columns_above_zero_are_so_exactly) {
  state = random_numbers_from(20261125);
  long above = 0, told = 0, zero = 0;
  for (long contact = 0; contact < CONTACTS; contact++) {
    tp_cones cones;
    tp_scaled scaled;
    tp_vector twist, weight;
    arb_t power;
    arb_init(power);
    tp_vector_init(&twist);
    tp_vector_init(&weight);
    arb_set_si(weight.of + 1, -1);
    draw_contact(&cones);
    move(&cones);
    ck_assert(tp_scaled_init(&scaled, &cones, &weight, 64));
    draw_twist(&twist, &cones);
    const tp_filter filter = tp_filter_of(&twist, &scaled);
    for (long k = 0; k < 2 * cones.count; k++) {
      tp_vector column;
      tp_vector_init(&column);
      tp_cones_column(column.of, &cones, k, EXACT);
      tp_vector_dot(power, &twist, &column, EXACT);
      ck_assert(arb_is_exact(power));
      const int sign = arf_sgn(arb_midref(power));
      const bool says = tp_filter_is_above_zero(&filter, scaled.columns[k]);
      ck_assert(!says || sign > 0);
      above += sign > 0;
      zero += sign == 0;
      told += says;
      tp_vector_clear(&column);
    }
    tp_scaled_clear(&scaled);
    tp_vector_clear(&twist);
    tp_vector_clear(&weight);
    arb_clear(power);
    tp_cones_clear(&cones);
  }
  printf("columns: %ld above zero, %ld told so, %ld exactly zero\n", above, told, zero);
  ck_assert_int_gt(told, above / 2);
  ck_assert_int_gt(zero, CONTACTS);
}
END_TEST

/* ---- motion/tilt_side.h ---------------------------------------------------------------------- */

/* From one tilt to another, or without an end. */
static void draw_stretch(tp_tilt_span *stretch) {
  const long from = draw_below(&state, 170) - 85, to = from + 1 + draw_below(&state, 86 - from);
  stretch->from.endless = draw_below(&state, 4) == 0;
  stretch->to.endless = draw_below(&state, 4) == 0;
  stretch->from.source.a = 1;
  stretch->to.source.a = 2;
  arb_set_si(stretch->from.degrees, from);
  arb_set_si(stretch->to.degrees, to);
}

/* What the inequality leaves of a span by its zeros in balls: all of it, or none, where that is
 * said.
 */
START_TEST(sides_of_spans_are_those_of_balls) {
  enum { WAVES = 4000 };
  const tp_judge judge = {.bits = 128, .precision = 128, .settled = true};
  long told = 0, uncut = 0;
  state = random_numbers_from(23);
  for (int wave = 0; wave < WAVES; wave++) {
    tp_motion_tilts own = {0}, other = {0};
    tp_trig f;
    tp_tilt zero;
    tp_answer known = TP_OPEN;
    tp_trig_init(&f);
    tp_tilt_init(&zero);
    draw_fraction(f.of + TP_COS, 4, 3);
    draw_fraction(f.of + TP_SIN, 4, 3);
    if (draw_below(&state, 4) > 0) draw_fraction(f.of + TP_ONE, 4, 3);
    tp_tilt_span *stretch = tp_tilts_add(&own);
    draw_stretch(stretch);
    const tp_answer side = tp_tilts_side(&own, &f);
    arb_t from, to;
    arb_init(from);
    arb_init(to);
    arb_set(from, stretch->from.degrees);
    arb_set(to, stretch->to.degrees);
    const bool from_endless = stretch->from.endless, to_endless = stretch->to.endless;
    ck_assert(tp_tilts_of(&other, &known, &f, &zero, 0, &judge));
    if (known == TP_YES) ck_assert(tp_tilts_intersect(&own, &known, &other, ~0U, &judge));
    if (known == TP_YES) {
      const bool same = own.count == 1 && own.items->from.endless == from_endless &&
                        own.items->to.endless == to_endless &&
                        (from_endless || arb_equal(own.items->from.degrees, from)) &&
                        (to_endless || arb_equal(own.items->to.degrees, to));
      ck_assert(side != TP_YES || same);
      ck_assert(side != TP_NO || own.count == 0);
      uncut += same || own.count == 0;
      told += side != TP_OPEN;
    }
    arb_clear(from);
    arb_clear(to);
    tp_tilt_clear(&zero);
    tp_trig_clear(&f);
    tp_tilts_clear(&own);
    tp_tilts_clear(&other);
  }
  printf("spans: %ld kept or lost whole, %ld told so\n", uncut, told);
  ck_assert_int_gt(told, uncut / 2);
}
END_TEST

SUITE(filters) {
  Suite *suite = suite_create("filters");
  TCase *cases = tcase_create("filters");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, tilts_of_modes_are_those_of_balls);
  tcase_add_test(cases, columns_above_zero_are_so_exactly);
  tcase_add_test(cases, sides_of_spans_are_those_of_balls);
  suite_add_tcase(suite, cases);
  return suite;
}
