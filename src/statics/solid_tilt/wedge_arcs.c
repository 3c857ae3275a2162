/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arcs of azimuths, halved where they do not tell, the first ones first. */

#include "solid_tilt/wedge_arcs.h"

#include <math.h>

enum { BITS = TP_WEDGE_LAW_BITS, FIRST = 16, HALVINGS = 46, MOST_ARCS = 20000 };

enum { EAST, NORTH, ARC_EAST, ARC_NORTH, MARGIN, SLOPE, FORCE, SPARE, NUMBERS };

typedef struct arcs {
  const tp_wedge_law *law;
  const arb_struct *t, *factor;
  arb_struct middle[TP_WEDGE_LINES]; /* values at the middle of an arc, */
  arb_struct all[TP_WEDGE_LINES];    /* on all of it, */
  arb_struct slopes[TP_WEDGE_LINES]; /* and how they change on it with the azimuth, in half turns */
  arb_struct n[NUMBERS];
} arcs;

static void each(arcs *a, void (*what)(arb_t number)) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) {
    what(a->middle + k);
    what(a->all + k);
    what(a->slopes + k);
  }
  for (int k = 0; k < NUMBERS; k++) what(a->n + k);
}

/* t (sin, cos) of half turns within a radius. */
static void set_force(arcs *a, int at, double half_turns, double radius) {
  arb_struct *east = a->n + at, *north = a->n + at + 1;
  arb_set_d(north, half_turns);
  mag_set_d(arb_radref(north), radius);
  arb_sin_cos_pi(east, north, north, BITS);
  arb_mul(east, east, a->t, BITS);
  arb_mul(north, north, a->t, BITS);
}

/* Widened by how far a slope takes it. */
static void add_reach(arb_t value, const arb_t slope, double radius) {
  mag_t most, own;
  mag_init(most);
  mag_init(own);
  arb_get_mag(most, slope);
  mag_set_d(own, radius);
  mag_mul(most, most, own);
  mag_add(arb_radref(value), arb_radref(value), most);
  mag_clear(most);
  mag_clear(own);
}

static void set_arc(arcs *a, double half_turns, double radius) {
  set_force(a, EAST, half_turns, 0);
  set_force(a, ARC_EAST, half_turns, radius);
  tp_wedge_values(a->middle, a->law, a->n + EAST, a->n + NORTH, false);
  /* pi t (cos, -sin) */
  arb_neg(a->n + SPARE, a->n + ARC_EAST);
  tp_wedge_values(a->slopes, a->law, a->n + ARC_NORTH, a->n + SPARE, true);
  arb_const_pi(a->n + SPARE, BITS);
  for (int k = 0; k < TP_WEDGE_LINES; k++) {
    arb_mul(a->slopes + k, a->slopes + k, a->n + SPARE, BITS);
    arb_set(a->all + k, a->middle + k);
    add_reach(a->all + k, a->slopes + k, radius);
  }
}

/* ---- one way -----------------------------------------------------------------------------------
 */

/* Is the margin above zero on the arc, by its value in the middle and its slope? */
static bool is_above(arcs *a, double radius) {
  add_reach(a->n + MARGIN, a->n + SLOPE, radius);
  return arb_is_positive(a->n + MARGIN);
}

static bool holds_on_both(arcs *a, double radius) {
  bool holds = true;
  for (int up = 0; up < 2 && holds; up++) {
    tp_wedge_strength(a->n + MARGIN, a->law, TP_WEDGE_ON_BOTH, a->middle, false);
    tp_wedge_strength(a->n + SLOPE, a->law, TP_WEDGE_ON_BOTH, a->slopes, true);
    arb_mul(a->n + FORCE, a->factor, a->middle + TP_WEDGE_ALONG, BITS);
    (up ? arb_sub : arb_add)(a->n + MARGIN, a->n + MARGIN, a->n + FORCE, BITS);
    arb_mul(a->n + FORCE, a->factor, a->slopes + TP_WEDGE_ALONG, BITS);
    (up ? arb_sub : arb_add)(a->n + SLOPE, a->n + SLOPE, a->n + FORCE, BITS);
    holds = is_above(a, radius);
  }
  return holds;
}

static bool holds_on_one(arcs *a, tp_wedge_way way, double radius) {
  const int across = way == TP_WEDGE_ON_A ? TP_WEDGE_ACROSS_A : TP_WEDGE_ACROSS_B;
  tp_wedge_strength(a->n + MARGIN, a->law, way, a->middle, false);
  tp_wedge_driving(a->n + FORCE, way, a->middle);
  arb_submul(a->n + MARGIN, a->factor, a->n + FORCE, BITS);
  if (!arb_is_positive(a->n + MARGIN)) return false;
  /* (p p' + q q') / sqrt(p^2 + q^2), of which each quotient is within 1 where both vanish */
  tp_wedge_driving(a->n + FORCE, way, a->all);
  if (arb_is_positive(a->n + FORCE)) {
    arb_mul(a->n + SPARE, a->all + TP_WEDGE_ALONG, a->slopes + TP_WEDGE_ALONG, BITS);
    arb_addmul(a->n + SPARE, a->all + across, a->slopes + across, BITS);
    arb_div(a->n + FORCE, a->n + SPARE, a->n + FORCE, BITS);
  } else {
    arb_hypot(a->n + FORCE, a->slopes + TP_WEDGE_ALONG, a->slopes + across, BITS);
    arb_zero(a->n + SPARE);
    arb_sub(a->n + SPARE, a->n + SPARE, a->n + FORCE, BITS);
    arb_union(a->n + FORCE, a->n + FORCE, a->n + SPARE, BITS);
  }
  tp_wedge_strength(a->n + SLOPE, a->law, way, a->slopes, true);
  arb_submul(a->n + SLOPE, a->factor, a->n + FORCE, BITS);
  return is_above(a, radius);
}

/* ---- an arc ------------------------------------------------------------------------------------
 */

static bool may_be_below(const arb_t number) {
  return !arb_is_nonnegative(number);
}

static bool may_not_press(const arb_t number) {
  return !arb_is_positive(number);
}

/* On every way that may be gone on the arc. */
static bool holds(arcs *a, double radius) {
  const arb_struct *normals = a->all + TP_WEDGE_NORMAL_A, *press = a->all + TP_WEDGE_PRESS_A;
  const bool leaves_a = may_be_below(normals), leaves_b = may_be_below(normals + 1);
  const bool off_b = leaves_b && may_not_press(press), off_a = leaves_a && may_not_press(press + 1);
  const bool none = (off_b && !arb_is_negative(normals)) ||
                    (off_a && !arb_is_negative(normals + 1)) || (off_a && off_b);
  if (none) return false;
  const bool both = !arb_is_negative(normals) && !arb_is_negative(normals + 1);
  if (both && !holds_on_both(a, radius)) return false;
  if (leaves_b && !arb_is_nonpositive(press) && !holds_on_one(a, TP_WEDGE_ON_A, radius)) {
    return false;
  }
  return !leaves_a || arb_is_nonpositive(press + 1) || holds_on_one(a, TP_WEDGE_ON_B, radius);
}

/* In its middle, certainly? */
static bool fails(arcs *a) {
  const tp_wedge_way way = tp_wedge_way_of(a->middle);
  if (way == TP_WEDGE_UNKNOWN || way == TP_WEDGE_ON_NONE) return way == TP_WEDGE_ON_NONE;
  tp_wedge_strength(a->n + MARGIN, a->law, way, a->middle, false);
  tp_wedge_driving(a->n + FORCE, way, a->middle);
  arb_mul(a->n + FORCE, a->n + FORCE, a->factor, BITS);
  return arb_lt(a->n + MARGIN, a->n + FORCE);
}

tp_wedge_round tp_wedge_arcs(double *half_turns, const tp_wedge_law *law, const arb_t t,
                             const arb_t factor) {
  /* of so many sizes there is one arc each to come back to, but for the first */
  double middles[FIRST + HALVINGS], radii[FIRST + HALVINGS];
  arcs a = {.law = law, .t = t, .factor = factor};
  tp_wedge_round found = TP_WEDGE_HOLDS;
  int count = 0, tried = 0;
  each(&a, arb_init);
  for (; count < FIRST; count++) {
    radii[count] = 1.0 / FIRST;
    middles[count] = (2.0 * (FIRST - count) - 1) / FIRST;
  }
  while (count > 0 && found == TP_WEDGE_HOLDS) {
    const double middle = middles[--count], radius = radii[count];
    set_arc(&a, middle, radius);
    if (holds(&a, radius)) continue;
    if (fails(&a)) {
      *half_turns = middle;
      found = TP_WEDGE_FAILS;
    } else if (++tried > MOST_ARCS || radius < ldexp(1.0 / FIRST, -HALVINGS + 2)) {
      found = TP_WEDGE_OPEN;
    } else {
      for (int side = 1; side >= 0; side--, count++) {
        radii[count] = radius / 2;
        middles[count] = middle + (side == 0 ? -radius : radius) / 2;
      }
    }
  }
  each(&a, arb_clear);
  return found;
}
