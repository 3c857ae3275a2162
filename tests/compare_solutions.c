/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "compare_solutions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BITS = 256 };

void relation_init(relation *r) {
  memset(r, 0, sizeof *r);
  for (int k = 0; k < RELATION_NUMBERS; k++) fmpq_init(r->numbers + k);
  fmpq_one(r->numbers + MAP_XX);
  fmpq_one(r->numbers + MAP_YY);
  fmpq_one(r->numbers + LENGTH);
  arb_init(r->turn_deg);
}

void relation_clear(relation *r) {
  for (int k = 0; k < RELATION_NUMBERS; k++) fmpq_clear(r->numbers + k);
  arb_clear(r->turn_deg);
}

typedef struct comparison {
  const relation *r;
  char *why;
  const char *where;  /* which case */
  bool towards_right; /* it is */
} comparison;

static void need(const comparison *c, bool holds, const char *what) {
  if (!holds && c->why[0] == '\0') snprintf(c->why, 256, "%s %s", what, c->where);
}

static void set_ball(arb_t ball, tp_bounded number) {
  arf_set_d(arb_midref(ball), number.value);
  mag_set_d(arb_radref(ball), number.error);
}

static void need_ball(const comparison *c, const arb_t expected, tp_bounded number,
                      const char *what) {
  arb_t ball;
  arb_init(ball);
  need(c, isfinite(number.value) && number.error >= 0, what);
  set_ball(ball, number);
  need(c, arb_overlaps(expected, ball) != 0, what);
  arb_clear(ball);
}

/* The other is the one times the length to a power. */
static void need_number(const comparison *c, tp_bounded one, tp_bounded other, int power,
                        const char *what) {
  arb_t expected, length;
  arb_init(expected);
  arb_init(length);
  set_ball(expected, one);
  arb_set_fmpq(length, c->r->numbers + LENGTH, BITS);
  arb_pow_ui(length, length, (ulong)power, BITS);
  arb_mul(expected, expected, length, BITS);
  need_ball(c, expected, other, what);
  arb_clear(expected);
  arb_clear(length);
}

static void add_product(arb_t sum, const fmpq *factor, const arb_t ball) {
  arb_t own;
  arb_init(own);
  arb_set_fmpq(own, factor, BITS);
  arb_addmul(sum, own, ball, BITS);
  arb_clear(own);
}

/* Row `row` of the map on (x, y). */
static void map_row(arb_t result, const relation *r, int row, const arb_t x, const arb_t y) {
  arb_zero(result);
  add_product(result, r->numbers + 2 * row, x);
  add_product(result, r->numbers + 2 * row + 1, y);
}

static void need_point(const comparison *c, const tp_bounded one[2], const tp_bounded other[2],
                       const char *what) {
  arb_t x, y, expected, shift;
  arb_init(x);
  arb_init(y);
  arb_init(expected);
  arb_init(shift);
  set_ball(x, one[0]);
  set_ball(y, one[1]);
  for (int row = 0; row < 2; row++) {
    map_row(expected, c->r, row, x, y);
    arb_set_fmpq(shift, c->r->numbers + SHIFT_X + row, BITS);
    arb_add(expected, expected, shift, BITS);
    need_ball(c, expected, other[row], what);
  }
  arb_clear(x);
  arb_clear(y);
  arb_clear(expected);
  arb_clear(shift);
}

/* M' = length^2 map M map^T about the centroid. */
static void need_second_moments(const comparison *c, const tp_block_result *one,
                                const tp_block_result *other) {
  arb_struct *m = _arb_vec_init(8), *half = m + 3, *expected = m + 7;
  arb_t area;
  arb_init(area);
  arb_set_fmpq(area, c->r->numbers + LENGTH, BITS);
  arb_mul(area, area, area, BITS);
  set_ball(m, one->second_moment_xx_m4);
  set_ball(m + 1, one->second_moment_xy_m4);
  set_ball(m + 2, one->second_moment_yy_m4);
  for (int row = 0; row < 2; row++) { /* map M */
    map_row(half + 2 * row, c->r, row, m, m + 1);
    map_row(half + 2 * row + 1, c->r, row, m + 1, m + 2);
  }
  const tp_bounded results[3] = {other->second_moment_xx_m4, other->second_moment_xy_m4,
                                 other->second_moment_yy_m4};
  for (int k = 0; k < 3; k++) {
    const arb_struct *row = half + 2 * (k == 2);
    map_row(expected, c->r, k > 0, row, row + 1);
    arb_mul(expected, expected, area, BITS);
    need_ball(c, expected, results[k], "second moment");
  }
  arb_clear(area);
  _arb_vec_clear(m, 8);
}

/* Towards the left the other is the one less the turn, in degrees; towards the right, and more. Of
 * pivots they go about all of a circle. */
static void need_angle(const comparison *c, tp_bounded one, tp_bounded other, const char *what) {
  arb_t expected;
  arb_init(expected);
  set_ball(expected, one);
  if (c->towards_right) {
    arb_add(expected, expected, c->r->turn_deg, BITS);
  } else {
    arb_sub(expected, expected, c->r->turn_deg, BITS);
  }
  if (c->r->turned && arf_cmp_d(arb_midref(expected), other.value - 180) < 0) {
    arb_add_ui(expected, expected, 360, BITS);
  }
  if (c->r->turned && arf_cmp_d(arb_midref(expected), other.value + 180) > 0) {
    arb_sub_ui(expected, expected, 360, BITS);
  }
  need_ball(c, expected, other, what);
  arb_clear(expected);
}

static void need_fos(const comparison *c, tp_fos one, tp_fos other, const char *what) {
  if (c->r->turned) return;
  const bool open = one.state == TP_FOS_UNDECIDED || other.state == TP_FOS_UNDECIDED;
  need(c, one.state == other.state || open || c->r->uncertain, what);
  if (one.state == TP_FOS_NUMBER && other.state == TP_FOS_NUMBER) {
    need_number(c, one.value, other.value, 0, what);
  }
}

static void compare_blocks(const comparison *c, const tp_solution *one, const tp_solution *other) {
  const tp_block_result *a = &one->block, *b = &other->block;
  need_number(c, a->area_m2, b->area_m2, 2, "area");
  need_number(c, a->weight_n, b->weight_n, 2, "weight");
  need_point(c, (tp_bounded[]){a->centroid_x_m, a->centroid_y_m},
             (tp_bounded[]){b->centroid_x_m, b->centroid_y_m}, "centroid");
  need_second_moments(c, a, b);
  need_number(c, one->contact.length_m, other->contact.length_m, 1, "length of contact");
  if (c->r->turned) return;
  need_number(c, one->contact.nominal_length_m, other->contact.nominal_length_m, 1,
              "nominal length");
}

static bool meet(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

/* Which of the other's pivots this one is: one of its kind, in its place and with its angle. Far
 * off, places alone do not tell neighbours apart. */
static size_t counterpart(const comparison *c, const tp_case *one, const tp_case *other, size_t k) {
  if (!c->r->more_vertices) return c->r->mirrored ? one->pivot_count - 1 - k : k;
  for (size_t i = k; i < other->pivot_count; i++) {
    const tp_pivot *p = one->pivots + k, *q = other->pivots + i;
    if (p->kind == q->kind && p->admissible == q->admissible && meet(p->x_m, q->x_m) &&
        meet(p->y_m, q->y_m) && meet(p->critical_angle_deg, q->critical_angle_deg)) {
      return i;
    }
  }
  need(c, false, "a pivot is missing");
  return 0;
}

/* A turn takes an angle past 180 degrees round to -180, from the last of the pivots to the first.
 */
static bool goes_round(const comparison *c, const tp_case *one) {
  enum { CLEAR_OF_ROUND = 140 }; /* no turn is larger than 40 degrees */
  bool any = false;
  for (size_t k = 0; k < one->pivot_count && c->r->turned; k++) {
    const tp_pivot *p = one->pivots + k;
    any = any || (p->admissible && fabs(p->critical_angle_deg.value) > CLEAR_OF_ROUND);
  }
  return any;
}

static void compare_pivots(const comparison *c, const tp_case *one, const tp_case *other) {
  const bool counted = one->pivot_count == other->pivot_count;
  need(c, counted || (c->r->more_vertices && one->pivot_count < other->pivot_count),
       "number of pivots");
  for (size_t k = 0; k < one->pivot_count && c->why[0] == '\0'; k++) {
    const tp_pivot *p = one->pivots + k, *q = other->pivots + counterpart(c, one, other, k);
    need_point(c, (tp_bounded[]){p->x_m, p->y_m}, (tp_bounded[]){q->x_m, q->y_m}, "pivot");
    need(c, p->admissible == q->admissible, "admissible pivot");
    need(c, p->kind == q->kind || c->r->turned, "kind of pivot");
    need_angle(c, p->critical_angle_deg, q->critical_angle_deg, "critical angle of a pivot");
    need_fos(c, p->fos_resultant, q->fos_resultant, "factor of safety of a pivot");
  }
  need(c, one->has_governing == other->has_governing, "some pivot governs");
  if (c->r->uncertain || !one->has_governing || goes_round(c, one)) return;
  need(c, one->governing_tie == other->governing_tie, "tie of pivots");
  if (c->why[0] != '\0' || one->governing_tie) return;
  need(c, counterpart(c, one, other, one->governing) == other->governing, "governing pivot");
}

/* Turned on the table, an angle can leave what a limit is sought over. */
static bool limits_compare(const comparison *c, const tp_limit *one, const tp_limit *other) {
  enum { CLEAR_OF_UPRIGHT = 50 }; /* no turn is larger than 40 degrees */
  if (!c->r->turned) return true;
  const bool near =
      one->kind == TP_LIMIT_AT_ANGLE && fabs(one->critical_angle_deg.value) < CLEAR_OF_UPRIGHT;
  if (near) need(c, other->kind == TP_LIMIT_AT_ANGLE, "the turned limit is an angle");
  return near;
}

static void compare_limits(const comparison *c, const tp_limit *one, const tp_limit *other,
                           const char *what) {
  if (!limits_compare(c, one, other)) return;
  need(c, one->kind == other->kind, what);
  if (one->kind != TP_LIMIT_AT_ANGLE || c->why[0] != '\0') return;
  need_angle(c, one->critical_angle_deg, other->critical_angle_deg, what);
  need(c, one->tie == other->tie, "tie of mechanisms");
  need(c, one->mechanism == other->mechanism || (one->tie && one->mechanism == other->tied_with),
       "mechanism of the limit");
  need_fos(c, one->fos, other->fos, "factor of safety of the limit");
  if (one->tie || !one->has_centre) return;
  need(c, one->turns_up_dip == other->turns_up_dip, "sense of turning");
  need_point(c, (tp_bounded[]){one->centre_x_m, one->centre_y_m},
             (tp_bounded[]){other->centre_x_m, other->centre_y_m}, "centre of the limit");
}

static void compare_sliding(const comparison *c, const tp_case *one, const tp_case *other) {
  const tp_sliding *a = &one->sliding, *b = &other->sliding;
  need(c, a->known == b->known && a->never == b->never, "sliding");
  if (a->known && !a->never) {
    need_angle(c, a->critical_angle_deg, b->critical_angle_deg, "sliding angle");
    need_angle(c, a->facet_angle_deg, b->facet_angle_deg, "facet angle");
    need_fos(c, a->fos, b->fos, "factor of sliding");
    need_fos(c, a->fos_strength, b->fos_strength, "factor of sliding by strength");
  }
  if (one->governing_tie) return; /* two toes */
  const tp_toe *s = &one->toe, *t = &other->toe;
  need(c, s->known == t->known && s->holds == t->holds && s->upright == t->upright, "toe");
  if (s->known && !s->upright) {
    need_angle(c, s->limit_angle_deg, t->limit_angle_deg, "limit angle of the toe");
  }
}

static void compare_verdicts(const comparison *c, const tp_case *one, const tp_case *other) {
  need(c, one->base_matters == other->base_matters, "the base matters");
  need(c,
       one->mechanism == other->mechanism ||
           (one->limit.tie && one->limit.mechanism == other->limit.tied_with),
       "mechanism");
  need(c, one->falls_backwards == other->falls_backwards, "falls backwards");
  need(c, one->has_margin == other->has_margin, "margin");
  if (one->has_margin) need_number(c, one->margin_deg, other->margin_deg, 0, "margin");
}

static void compare_cases(const comparison *c, const tp_case *one, const tp_case *other) {
  compare_pivots(c, one, other);
  if (c->r->uncertain) return;
  compare_limits(c, &one->limit, &other->limit, "limit");
  if (c->r->turned) return;
  compare_limits(c, &one->limit_otherwise, &other->limit_otherwise, "limit otherwise");
  compare_limits(c, &one->limit_back, &other->limit_back, "limit of tilting back");
  compare_sliding(c, one, other);
  compare_verdicts(c, one, other);
}

bool solutions_agree(char why[256], const tp_solution *one, const tp_solution *other,
                     const relation *r) {
  comparison c = {r, why, "of the block", false};
  why[0] = '\0';
  need(&c, one->case_count == other->case_count, "number of cases");
  compare_blocks(&c, one, other);
  for (size_t k = 0; k < one->case_count && why[0] == '\0'; k++) {
    const tp_case *own = one->cases + k;
    c.towards_right = own->towards == TP_TOWARDS_RIGHT;
    c.where = c.towards_right ? "towards the right" : "towards the left";
    compare_cases(&c, own, other->cases + (r->mirrored ? one->case_count - 1 - k : k));
  }
  return why[0] == '\0';
}
