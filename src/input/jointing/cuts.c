/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Segments gathered, exact directions, and what a section is measured by. */

#include "jointing/cuts.h"

#include "common/grow.h"

#include <arb.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 128, TANGENT_BITS = 34 };

/* ---- points ------------------------------------------------------------------------------------
 */

void tp_cut_point_init(tp_cut_point *point) {
  fmpq_init(point->x);
  fmpq_init(point->y);
}

void tp_cut_point_clear(tp_cut_point *point) {
  fmpq_clear(point->x);
  fmpq_clear(point->y);
}

static void go(fmpq_t result, const fmpq_t from, const fmpq_t length, const fmpq_t direction) {
  fmpq_t way;
  fmpq_init(way);
  fmpq_mul(way, length, direction);
  fmpq_add(result, from, way);
  fmpq_clear(way);
}

void tp_cut_point_go(tp_cut_point *result, const tp_cut_point *p, const fmpq_t length,
                     const tp_cut_point *direction) {
  go(result->x, p->x, length, direction->x);
  go(result->y, p->y, length, direction->y);
}

/* The simplest fraction within 2^-TANGENT_BITS of the tangent of half the angle, which is off by
 * twice that at most. Of an angle and its opposite they are opposite. */
static void half_tangent(fmpq_t tangent, const fmpq_t angle_deg) {
  arb_t ball;
  fmpq_t low, high, size;
  arb_init(ball);
  fmpq_init(low);
  fmpq_init(high);
  fmpq_init(size);
  fmpq_abs(size, angle_deg);
  arb_set_fmpq(ball, size, BITS);
  arb_div_ui(ball, ball, 360, BITS);
  arb_tan_pi(ball, ball, BITS);
  arf_get_fmpq(low, arb_midref(ball));
  fmpq_one(size);
  fmpq_div_2exp(size, size, TANGENT_BITS);
  fmpq_add(high, low, size);
  fmpq_sub(low, low, size);
  fmpq_simplest_between(tangent, low, high);
  if (fmpq_sgn(angle_deg) < 0) fmpq_neg(tangent, tangent);
  arb_clear(ball);
  fmpq_clear(low);
  fmpq_clear(high);
  fmpq_clear(size);
}

void tp_direction_of_degrees(tp_cut_point *direction, const fmpq_t angle_deg) {
  fmpq_t t, square, sum;
  fmpq_init(t);
  fmpq_init(square);
  fmpq_init(sum);
  half_tangent(t, angle_deg);
  fmpq_mul(square, t, t);
  fmpq_add_si(sum, square, 1);
  fmpq_sub_si(square, square, 1);
  fmpq_neg(square, square);
  fmpq_div(direction->x, square, sum);
  fmpq_mul_2exp(t, t, 1);
  fmpq_div(direction->y, t, sum);
  fmpq_clear(t);
  fmpq_clear(square);
  fmpq_clear(sum);
}

/* ---- segments ----------------------------------------------------------------------------------
 */

bool tp_cuts_add(tp_cuts *cuts, const tp_cut_point *from, const tp_cut_point *to, tp_cut of) {
  if (fmpq_equal(from->x, to->x) && fmpq_equal(from->y, to->y)) return true;
  tp_cut *kinds = tp_grow(cuts->of, cuts->count, &cuts->room, sizeof *kinds);
  if (kinds == NULL) return false;
  cuts->of = kinds;
  fmpq *ends = tp_grow(cuts->ends, cuts->count, &cuts->ends_room, 4 * sizeof *ends);
  if (ends == NULL) return false;
  cuts->ends = ends;
  const fmpq *const numbers[] = {from->x, from->y, to->x, to->y};
  for (int k = 0; k < 4; k++) {
    fmpq *own = ends + 4 * cuts->count + k;
    fmpq_init(own);
    fmpq_set(own, numbers[k]);
  }
  kinds[cuts->count++] = of;
  return true;
}

void tp_cuts_clear(tp_cuts *cuts) {
  for (long k = 0; k < 4 * cuts->count; k++) fmpq_clear(cuts->ends + k);
  for (long k = 0; k < cuts->corner_count; k++) tp_cut_point_clear(cuts->corners + k);
  for (long s = 0; cuts->traces != NULL && s < cuts->slope->set_count; s++) {
    for (long k = 0; k < cuts->traces[s].count; k++) {
      tp_cut_point_clear(&cuts->traces[s].lines[k].foot);
      tp_cut_point_clear(&cuts->traces[s].lines[k].along);
    }
    free(cuts->traces[s].lines);
  }
  tp_cut_point_clear(&cuts->toe);
  free(cuts->ends);
  free(cuts->of);
  free(cuts->corners);
  free(cuts->x);
  free(cuts->y);
  free(cuts->traces);
  memset(cuts, 0, sizeof *cuts);
}

tp_status tp_cuts_init(tp_cuts *cuts, const tp_jointed_slope *slope, tp_message *message) {
  memset(cuts, 0, sizeof *cuts);
  cuts->slope = slope;
  tp_cut_point_init(&cuts->toe);
  fmpq_set(cuts->toe.x, slope->toe_x.value);
  fmpq_set(cuts->toe.y, slope->toe_y.value);
  if (slope->right) fmpq_neg(cuts->toe.x, cuts->toe.x);
  cuts->traces = calloc((size_t)slope->set_count + 1, sizeof *cuts->traces);
  if (cuts->traces != NULL) return TP_OK;
  tp_cuts_clear(cuts);
  return tp_fail_memory(message, "the joints");
}

/* ---- measures ----------------------------------------------------------------------------------
 */

void tp_cuts_reach(const tp_cuts *cuts, const tp_cut_point *direction, double *least,
                   double *most) {
  const double c = fmpq_get_d(direction->x), s = fmpq_get_d(direction->y);
  *least = INFINITY;
  *most = -INFINITY;
  for (long k = 0; k < cuts->corner_count; k++) {
    const double along = c * cuts->x[k] + s * cuts->y[k];
    *least = fmin(*least, along);
    *most = fmax(*most, along);
  }
}

double tp_cuts_size(const tp_cuts *cuts) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (long k = 0; k < cuts->corner_count; k++) {
    low[0] = fmin(low[0], cuts->x[k]);
    high[0] = fmax(high[0], cuts->x[k]);
    low[1] = fmin(low[1], cuts->y[k]);
    high[1] = fmax(high[1], cuts->y[k]);
  }
  return high[0] - low[0] + high[1] - low[1];
}

tp_quote tp_joint_set_name(const tp_jointed_slope *slope, long set) {
  if (slope->sets[set].name != NULL) return tp_quote_all(slope->sets[set].name);
  tp_quote number;
  snprintf(number.text, sizeof number.text, "%ld", set + 1);
  return number;
}
