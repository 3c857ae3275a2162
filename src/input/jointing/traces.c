/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Traces of joint sets. Number k of a set lies at a distance c_k from the toe, along its normal:
 *     c_0 = offset,  c_{k+1} = c_k + spacing (1 + s u_k),
 * and has the angle of the set, plus d u'_k. Where it is not persistent open pieces of one length
 * stand in it at equal gaps, length (1 - p) / p, from a random place on. The u are random numbers
 * by k alone, so that they stay as they are where the section is made longer. */

#include "jointing/traces.h"

#include "common/grow.h"
#include "generate/random.h"
#include "jointing/joint_count.h"
#include "jointing/joint_layout.h"
#include "number/word.h"
#include "scene/rule_check.h"

#include <math.h>
#include <stdlib.h>

static const double most_steps = 1e6;

/* Evenly within (-1, 1), an odd multiple of 2^-32. */
static void random_even(fmpq_t u, uint64_t stream, long k) {
  const int64_t bits = (int64_t)(tp_random_bits(stream, (uint64_t)k) >> 32);
  fmpz_one(fmpq_denref(u));
  tp_word_set(fmpq_numref(u), 2 * bits + 1 - (INT64_C(1) << 32));
  fmpq_div_2exp(u, u, 32);
}

/* ---- lines -------------------------------------------------------------------------------------
 */

/* From trace k to the next one. */
static void step_from(fmpq_t step, const tp_joint_layout *l, long k) {
  if (fmpq_is_zero(l->set->spacing_scatter.value)) {
    fmpq_set(step, l->set->spacing.value);
    return;
  }
  random_even(step, l->random[TP_RANDOM_SPACING], k);
  fmpq_mul(step, step, l->set->spacing_scatter.value);
  fmpq_add_si(step, step, 1);
  fmpq_mul(step, step, l->set->spacing.value);
}

static bool add_line(const tp_joint_layout *l, const fmpq_t distance, long k) {
  tp_joint_traces *traces = l->cuts->traces + l->number;
  tp_joint_trace *lines = tp_grow(traces->lines, traces->count, &traces->room, sizeof *lines);
  if (lines == NULL) return false;
  traces->lines = lines;
  tp_joint_trace *own = lines + traces->count++;
  own->number = k;
  own->left = l->left;
  tp_cut_point_init(&own->foot);
  tp_cut_point_init(&own->along);
  tp_cut_point_go(&own->foot, &l->cuts->toe, distance, &l->normal);
  if (fmpq_is_zero(l->set->dip_scatter_deg.value)) {
    fmpq_set(own->along.x, l->along.x);
    fmpq_set(own->along.y, l->along.y);
    return true;
  }
  fmpq_t angle;
  fmpq_init(angle);
  random_even(angle, l->random[TP_RANDOM_DIP], k);
  fmpq_mul(angle, angle, l->set->dip_scatter_deg.value);
  fmpq_add(angle, angle, l->angle_deg);
  tp_direction_of_degrees(&own->along, angle);
  fmpq_clear(angle);
  return true;
}

/* From the last trace before `least`, or without scatter at once from the one next to it. */
static tp_status find_first(const tp_joint_layout *l, fmpq_t distance, long *k, double least,
                            tp_message *message) {
  const double way = least - fmpq_get_d(l->set->offset.value);
  const double steps = floor(way / fmpq_get_d(l->set->spacing.value)) - 1;
  fmpq_t step;
  if (!(fabs(steps) < most_steps)) {
    return tp_refuse(message, TP_FAULT_RANGE,
                     l->set->offset.given ? l->set->offset.place : l->set->place,
                     "the section lies more than %.0f spacings from the first joint of set '%s': "
                     "give an 'offset' near it, or its 'toe'",
                     most_steps, tp_joint_set_name(l->cuts->slope, l->number).text);
  }
  fmpq_init(step);
  *k = 0;
  fmpq_set(distance, l->set->offset.value);
  if (fmpq_is_zero(l->set->spacing_scatter.value)) {
    *k = (long)steps;
    fmpq_mul_si(step, l->set->spacing.value, *k);
    fmpq_add(distance, distance, step);
  }
  while (fmpq_get_d(distance) > least) {
    step_from(step, l, --*k);
    fmpq_sub(distance, distance, step);
  }
  fmpq_clear(step);
  return TP_OK;
}

static tp_status set_lines(const tp_joint_layout *l, tp_message *message) {
  double least = 0, most = 0;
  long k = 0;
  fmpq_t distance, step;
  tp_cuts_reach(l->cuts, &l->normal, &least, &most);
  const double turned =
      tp_cuts_size(l->cuts) * sin(fmpq_get_d(l->set->dip_scatter_deg.value) * (M_PI / 180));
  fmpq_init(distance);
  fmpq_init(step);
  tp_status status = find_first(l, distance, &k, least - turned, message);
  while (status == TP_OK && fmpq_get_d(distance) <= most + turned) {
    if (fmpq_get_d(distance) >= least - turned && !add_line(l, distance, k)) {
      status = tp_fail_memory(message, "the joints");
    }
    step_from(step, l, k++);
    fmpq_add(distance, distance, step);
  }
  fmpq_clear(distance);
  fmpq_clear(step);
  return status;
}

/* ---- pieces ------------------------------------------------------------------------------------
 */

/* Where a line is within the section, from its foot on: [low, high] and a little more, in whole
 * numbers of `grid`. */
static bool find_stretch(const tp_cuts *cuts, const tp_joint_trace *own, double grid,
                         long stretch[2]) {
  fmpq_t difference;
  fmpq_init(difference);
  fmpq_sub(difference, own->foot.x, cuts->toe.x);
  const double x = fmpq_get_d(difference), c = fmpq_get_d(own->along.x);
  fmpq_sub(difference, own->foot.y, cuts->toe.y);
  const double y = fmpq_get_d(difference), s = fmpq_get_d(own->along.y);
  fmpq_clear(difference);
  double low = INFINITY, high = -INFINITY;
  for (long k = 0; k < cuts->corner_count; k++) {
    const long n = (k + 1) % cuts->corner_count;
    const double px = cuts->x[k] - x, py = cuts->y[k] - y, qx = cuts->x[n] - x, qy = cuts->y[n] - y;
    const double p = c * py - s * px, q = c * qy - s * qx;
    if (!(p * q <= 0) || p == q) continue;
    const double from = c * px + s * py, to = c * qx + s * qy;
    const double at = from + (to - from) * (p / (p - q));
    low = fmin(low, at);
    high = fmax(high, at);
  }
  stretch[0] = low <= high ? (long)floor(low / grid) - 1 : 0;
  stretch[1] = low <= high ? (long)ceil(high / grid) + 1 : 0;
  return low <= high;
}

static bool add_piece(const tp_joint_layout *l, const tp_joint_trace *own, const fmpq_t from,
                      const fmpq_t to) {
  tp_cut_point first, last;
  tp_cut_point_init(&first);
  tp_cut_point_init(&last);
  tp_cut_point_go(&first, &own->foot, from, &own->along);
  tp_cut_point_go(&last, &own->foot, to, &own->along);
  const bool done = tp_cuts_add(l->cuts, &first, &last, (tp_cut){TP_CUT_TRACE, (int)l->number});
  tp_cut_point_clear(&first);
  tp_cut_point_clear(&last);
  return done;
}

/* Open pieces within [low, high], at a period of length / persistence. */
static bool add_open(const tp_joint_layout *l, const tp_joint_trace *own, const fmpq_t low,
                     const fmpq_t high) {
  fmpq_t period, from, to, end;
  fmpq_init(period);
  fmpq_init(from);
  fmpq_init(to);
  fmpq_init(end);
  fmpq_div(period, l->set->length.value, l->set->persistence.value);
  random_even(from, l->random[TP_RANDOM_BRIDGES], own->number);
  fmpq_mul(from, from, period); /* a piece begins here; the last one before `low` is wanted */
  fmpq_sub(to, low, from);
  fmpq_div(to, to, period);
  fmpz_fdiv_q(fmpq_numref(to), fmpq_numref(to), fmpq_denref(to));
  fmpz_one(fmpq_denref(to));
  fmpq_addmul(from, to, period);
  bool done = true;
  for (; fmpq_cmp(from, high) < 0 && done; fmpq_add(from, from, period)) {
    fmpq_add(end, from, l->set->length.value);
    if (fmpq_cmp(end, low) <= 0) continue;
    done = add_piece(l, own, fmpq_cmp(from, low) < 0 ? low : from,
                     fmpq_cmp(end, high) > 0 ? high : end);
  }
  fmpq_clear(period);
  fmpq_clear(from);
  fmpq_clear(to);
  fmpq_clear(end);
  return done;
}

static bool add_trace(const tp_joint_layout *l, const tp_joint_trace *own) {
  const int exponent = ilogb(tp_cuts_size(l->cuts)) - 10;
  long stretch[2];
  if (!find_stretch(l->cuts, own, ldexp(1, exponent), stretch)) return true;
  fmpq_t ends[2];
  for (int n = 0; n < 2; n++) {
    fmpq_init(ends[n]);
    fmpq_set_si(ends[n], stretch[n], 1);
    if (exponent >= 0) {
      fmpq_mul_2exp(ends[n], ends[n], (unsigned long)exponent);
    } else {
      fmpq_div_2exp(ends[n], ends[n], (unsigned long)-exponent);
    }
  }
  const bool done = fmpq_is_one(l->set->persistence.value) ? add_piece(l, own, ends[0], ends[1])
                                                           : add_open(l, own, ends[0], ends[1]);
  fmpq_clear(ends[0]);
  fmpq_clear(ends[1]);
  return done;
}

static tp_status add_set(tp_cuts *cuts, long number, uint64_t seed, tp_message *message) {
  tp_joint_layout l;
  tp_joint_layout_init(&l, cuts, number, seed);
  tp_status status = set_lines(&l, message);
  for (long k = 0; status == TP_OK && k < cuts->traces[number].count; k++) {
    if (!add_trace(&l, cuts->traces[number].lines + k))
      status = tp_fail_memory(message, "the joints");
  }
  tp_joint_layout_clear(&l);
  return status;
}

tp_status tp_cuts_traces(tp_cuts *cuts, tp_message *message) {
  uint64_t seed = 0;
  tp_status status = tp_joints_check_count(cuts, message);
  if (status == TP_OK && cuts->slope->seed.given) {
    status = tp_check_seed(&seed, &cuts->slope->seed, message);
  }
  for (long k = 0; k < cuts->slope->set_count && status == TP_OK; k++) {
    status = add_set(cuts, k, seed, message);
  }
  return status;
}
