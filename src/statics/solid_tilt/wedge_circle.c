/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples, golden section, and a certificate just below what was found; where it finds less, from
 * there; between what was proven and what was found, halved. */

#include "solid_tilt/wedge_circle.h"

#include "number/ball.h"
#include "solid_tilt/wedge_arcs.h"
#include "solid_tilt/wedge_reach.h"

#include <math.h>

enum { BITS = TP_WEDGE_LAW_BITS, SAMPLES = 24, SECTIONS = 44, ROUNDS = 90 };

static const double close = 1e-12;

typedef struct search {
  const tp_wedge_law *law;
  bool of_force;    /* else of the factor, at */
  arb_struct t;     /* this force */
  arb_struct value; /* at an azimuth, */
  arb_struct east, north, driving;
  arf_t low, high; /* the least of all is proven to lie between */
  bool found;
  double half_turns; /* where high was found */
  tp_wedge_way way;
} search;

/* The value at an azimuth; false: none, or not certain. */
static bool find_value(search *s, tp_wedge_way *way, double half_turns) {
  tp_wedge_direction(&s->east, &s->north, half_turns);
  if (s->of_force) return tp_wedge_reach(&s->value, way, s->law, &s->east, &s->north);
  arb_mul(&s->east, &s->east, &s->t, BITS);
  arb_mul(&s->north, &s->north, &s->t, BITS);
  if (!tp_wedge_law_at(way, &s->driving, &s->value, s->law, &s->east, &s->north)) return false;
  if (*way == TP_WEDGE_ON_NONE) return true; /* zero */
  if (!arb_is_positive(&s->driving)) return false;
  arb_div(&s->value, &s->value, &s->driving, BITS);
  return true;
}

/* The most that it can be at an azimuth; beyond all where there is none. */
static void look(search *s, arf_t high, double half_turns) {
  tp_wedge_way way = TP_WEDGE_UNKNOWN;
  arf_pos_inf(high);
  if (!find_value(s, &way, half_turns)) return;
  arb_get_ubound_arf(high, &s->value, BITS);
  if (arf_sgn(high) < 0) arf_zero(high);
  if (s->found && arf_cmp(high, s->high) >= 0) return;
  arf_set(s->high, high);
  s->found = true;
  s->half_turns = half_turns;
  s->way = way;
}

/* Golden section about an azimuth. */
static void polish(search *s, double middle, double radius) {
  static const double golden = 0.61803398874989485;
  double low = middle - radius, high = middle + radius;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  arf_t at_left, at_right;
  arf_init(at_left);
  arf_init(at_right);
  look(s, at_left, left);
  look(s, at_right, right);
  for (int k = 0; k < SECTIONS; k++) {
    if (arf_cmp(at_left, at_right) <= 0) {
      high = right;
      right = left;
      arf_swap(at_right, at_left);
      left = high - golden * (high - low);
      look(s, at_left, left);
    } else {
      low = left;
      left = right;
      arf_swap(at_left, at_right);
      right = low + golden * (high - low);
      look(s, at_right, right);
    }
  }
  arf_clear(at_left);
  arf_clear(at_right);
}

static void sample(search *s) {
  arf_t high;
  arf_init(high);
  for (int k = 0; k < SAMPLES; k++) look(s, high, 2.0 * k / SAMPLES);
  arf_clear(high);
  if (s->found) polish(s, s->half_turns, 2.0 / SAMPLES);
}

/* Is this a bound from below? Found: less at some azimuth, which is taken. */
static tp_wedge_round try_bound(search *s, const arf_t bound) {
  arb_t own, one;
  double half_turns = 0;
  arb_init(own);
  arb_init(one);
  arb_set_arf(own, bound);
  arb_one(one);
  const tp_wedge_round round = s->of_force ? tp_wedge_arcs(&half_turns, s->law, own, one)
                                           : tp_wedge_arcs(&half_turns, s->law, &s->t, own);
  if (round == TP_WEDGE_HOLDS) arf_set(s->low, bound);
  if (round == TP_WEDGE_FAILS) {
    arf_t high;
    arf_init(high);
    look(s, high, half_turns);
    if (arf_cmp(s->high, bound) > 0) { /* too close to tell, but certainly not above the bound */
      arf_set(s->high, bound);
      s->half_turns = half_turns;
    }
    polish(s, half_turns, 1.0 / SAMPLES);
    arf_clear(high);
  }
  arb_clear(own);
  arb_clear(one);
  return round;
}

static bool is_close(const search *s) {
  arf_t gap, size;
  arf_init(gap);
  arf_init(size);
  arf_sub(gap, s->high, s->low, BITS, ARF_RND_UP);
  arf_set_d(size, 2 * close);
  arf_mul(size, size, s->high, BITS, ARF_RND_DOWN);
  const bool is = arf_cmp(gap, size) <= 0;
  arf_clear(gap);
  arf_clear(size);
  return is;
}

static void certify(search *s) {
  arf_t bound;
  arf_init(bound);
  for (int k = 0; k < ROUNDS && !is_close(s); k++) {
    if (k % 2 == 0) {
      arf_set_d(bound, 1 - close);
      arf_mul(bound, bound, s->high, BITS, ARF_RND_DOWN);
    } else {
      arf_add(bound, s->low, s->high, BITS, ARF_RND_DOWN);
      arf_mul_2exp_si(bound, bound, -1);
    }
    if (try_bound(s, bound) == TP_WEDGE_OPEN && k % 2 == 1) break;
  }
  arf_clear(bound);
}

static void tell(tp_wedge_least *least, search *s) {
  *least = (tp_wedge_least){.found = s->found};
  if (!s->found) return;
  arb_set_interval_arf(&s->value, s->low, s->high, BITS);
  least->least = tp_ball_bounded(&s->value);
  least->half_turns = s->half_turns;
  least->way = s->way;
}

static void find(tp_wedge_least *least, const tp_wedge_law *law, const fmpq *t) {
  search s = {.law = law, .of_force = t == NULL};
  arb_struct *const numbers[] = {&s.t, &s.value, &s.east, &s.north, &s.driving};
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) arb_init(numbers[k]);
  arf_init(s.low);
  arf_init(s.high);
  if (t != NULL) arb_set_fmpq(&s.t, t, BITS);
  sample(&s);
  if (s.found) certify(&s);
  tell(least, &s);
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) arb_clear(numbers[k]);
  arf_clear(s.low);
  arf_clear(s.high);
}

void tp_wedge_least_factor(tp_wedge_least *least, const tp_wedge_law *law, const fmpq_t t) {
  find(least, law, t);
}

void tp_wedge_least_reach(tp_wedge_least *least, const tp_wedge_law *law) {
  find(least, law, NULL);
}
