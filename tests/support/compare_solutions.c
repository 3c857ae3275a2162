/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

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

/* M' = length^2 map M map^T about the centroid. */
static void need_second_moments(const comparison *c, const tp_block_result *one,
                                const tp_block_result *other) {
  arb_struct *m = _arb_vec_init(8), *half = m + 3, *expected = m + 7;
  arb_t area;
  arb_init(area);
  arb_set_fmpq(area, c->r->numbers + LENGTH, COMPARE_BITS);
  arb_mul(area, area, area, COMPARE_BITS);
  compare_set_ball(m, one->second_moment_xx_m4);
  compare_set_ball(m + 1, one->second_moment_xy_m4);
  compare_set_ball(m + 2, one->second_moment_yy_m4);
  for (int row = 0; row < 2; row++) { /* map M */
    compare_map_row(half + 2 * row, c->r, row, m, m + 1);
    compare_map_row(half + 2 * row + 1, c->r, row, m + 1, m + 2);
  }
  const tp_bounded results[3] = {other->second_moment_xx_m4, other->second_moment_xy_m4,
                                 other->second_moment_yy_m4};
  for (int k = 0; k < 3; k++) {
    const arb_struct *row = half + 2 * (k == 2);
    compare_map_row(expected, c->r, k > 0, row, row + 1);
    arb_mul(expected, expected, area, COMPARE_BITS);
    compare_ball(c, expected, results[k], "second moment");
  }
  arb_clear(area);
  _arb_vec_clear(m, 8);
}

static void compare_blocks(const comparison *c, const tp_solution *one, const tp_solution *other) {
  const tp_block_result *a = &one->block, *b = &other->block;
  compare_number(c, a->area_m2, b->area_m2, 2, "area");
  compare_number(c, a->weight_n, b->weight_n, 2, "weight");
  compare_point(c, (tp_bounded[]){a->centroid_x_m, a->centroid_y_m},
                (tp_bounded[]){b->centroid_x_m, b->centroid_y_m}, "centroid");
  need_second_moments(c, a, b);
  compare_number(c, one->contact.length_m, other->contact.length_m, 1, "length of contact");
  compare_need(c, one->contact.corner_points == other->contact.corner_points, "corners on corners");
  compare_need(c, one->contact.points == other->contact.points || c->r->more_vertices,
               "points of contact");
  compare_need(c, one->contact.facets == other->contact.facets || c->r->more_vertices, "facets");
  if (c->r->turned) return;
  compare_number(c, one->contact.nominal_length_m, other->contact.nominal_length_m, 1,
                 "nominal length");
}

static bool meet(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

static bool factors_meet(tp_fos a, tp_fos b) {
  if (a.state != b.state) return a.state == TP_FOS_UNDECIDED || b.state == TP_FOS_UNDECIDED;
  return a.state != TP_FOS_NUMBER || meet(a.value, b.value);
}

static bool limits_meet(const tp_pivot *p, const tp_pivot *q) {
  bool same = p->limit_count == q->limit_count;
  for (size_t k = 0; same && k < p->limit_count; k++) {
    same = meet(p->limits_deg[k], q->limits_deg[k]);
  }
  return same;
}

/* Which of the other's pivots this one is: one of its kind, in its place, with its angles and its
 * factor of safety. Far off, places alone do not tell neighbours apart. */
static size_t counterpart(const comparison *c, const tp_case *one, const tp_case *other, size_t k) {
  if (!c->r->more_vertices) return c->r->mirrored ? one->pivot_count - 1 - k : k;
  for (size_t i = k; i < other->pivot_count; i++) {
    const tp_pivot *p = one->pivots + k, *q = other->pivots + i;
    if (p->kind == q->kind && p->admissible == q->admissible && meet(p->x_m, q->x_m) &&
        meet(p->y_m, q->y_m) && meet(p->critical_angle_deg, q->critical_angle_deg) &&
        limits_meet(p, q) && factors_meet(p->fos, q->fos)) {
      return i;
    }
  }
  compare_need(c, false, "a pivot is missing");
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

/* Under loads: every tilt at which it begins to move, or holds again. */
static void need_limits(const comparison *c, const tp_pivot *p, const tp_pivot *q) {
  compare_need(c, p->never == q->never && p->always == q->always,
               "a pivot never or always topples");
  compare_need(c, p->rounded == q->rounded, "rounded pivot");
  if (c->r->turned || c->r->uncertain) return;
  compare_need(c, p->limit_count == q->limit_count, "tilts at which a pivot begins to move");
  for (size_t k = 0; k < p->limit_count && c->why[0] == '\0'; k++) {
    compare_angle(c, p->limits_deg[k], q->limits_deg[k], "a tilt at which a pivot begins to move");
  }
}

/* From the scene's tilt, which a turned block has not. */
static void compare_rolling(const comparison *c, const tp_case *one, const tp_case *other) {
  if (c->r->turned) return;
  compare_need(c, one->rolls == other->rolls && one->rests == other->rests, "rolling");
  if (one->rests) compare_angle(c, one->rest_turn_deg, other->rest_turn_deg, "turn of the rest");
}

static void compare_pivots(const comparison *c, const tp_case *one, const tp_case *other) {
  const bool counted = one->pivot_count == other->pivot_count;
  compare_need(c, counted || (c->r->more_vertices && one->pivot_count < other->pivot_count),
               "number of pivots");
  for (size_t k = 0; k < one->pivot_count && c->why[0] == '\0'; k++) {
    const tp_pivot *p = one->pivots + k, *q = other->pivots + counterpart(c, one, other, k);
    compare_point(c, (tp_bounded[]){p->x_m, p->y_m}, (tp_bounded[]){q->x_m, q->y_m}, "pivot");
    compare_need(c, p->admissible == q->admissible, "admissible pivot");
    compare_need(c, p->kind == q->kind || c->r->turned, "kind of pivot");
    need_limits(c, p, q);
    if (!p->never && !p->always) {
      compare_angle(c, p->critical_angle_deg, q->critical_angle_deg, "critical angle of a pivot");
    }
    compare_fos(c, p->fos, q->fos, "factor of safety of a pivot");
  }
  compare_rolling(c, one, other);
  compare_need(c, one->has_toppling_pivot == other->has_toppling_pivot, "some pivot governs");
  if (c->r->uncertain || !one->has_toppling_pivot || goes_round(c, one)) return;
  compare_need(c, one->toppling_tie == other->toppling_tie, "tie of pivots");
  if (c->why[0] != '\0' || one->toppling_tie) return;
  compare_need(c, counterpart(c, one, other, one->toppling_pivot) == other->toppling_pivot,
               "governing pivot");
}

/* The section keeps its thickness where it is scaled: weights grow as areas, moments as volumes. */
static void compare_loads(const comparison *c, const tp_case *one, const tp_case *other) {
  if (c->r->turned || one->toppling_tie) return;
  compare_need(c, one->load_count == other->load_count, "number of loads");
  for (size_t k = 0; k < one->load_count && c->why[0] == '\0'; k++) {
    compare_need(c, one->loads[k].side == other->loads[k].side, "side of a load");
    compare_number(c, one->loads[k].moment_nm, other->loads[k].moment_nm, 3, "moment of a load");
  }
}

static void compare_cases(const comparison *c, const tp_case *one, const tp_case *other) {
  compare_pivots(c, one, other);
  if (c->r->uncertain) return;
  compare_all_limits(c, one, other);
  compare_loads(c, one, other);
}

bool solutions_agree(char why[256], const tp_solution *one, const tp_solution *other,
                     const relation *r) {
  comparison c = {r, why, "of the block", false};
  why[0] = '\0';
  /* what is not certain may have the other shaking govern, which is told along other axes */
  if (r->uncertain && one->frame.level != other->frame.level) return true;
  compare_need(&c, one->case_count == other->case_count, "number of cases");
  compare_blocks(&c, one, other);
  for (size_t k = 0; k < one->case_count && why[0] == '\0'; k++) {
    const tp_case *own = one->cases + k;
    c.towards_right = own->towards == TP_TOWARDS_RIGHT;
    c.where = c.towards_right ? "towards the right" : "towards the left";
    compare_cases(&c, own, other->cases + (r->mirrored ? one->case_count - 1 - k : k));
  }
  return why[0] == '\0';
}
