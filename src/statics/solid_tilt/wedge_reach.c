/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Along a ray of forces, between the places where it crosses the lines of the ways, the way is one,
 * and what holds the wedge less what drives it is concave: it stands on all of such a stretch where
 * it does at both ends, and else up to the one root in it, of a line or of a quadratic. */

#include "solid_tilt/wedge_reach.h"

enum { BITS = TP_WEDGE_LAW_BITS, CROSSINGS = 4 };

enum { PROBE, LEFT, RIGHT, ROOT, A, B, C, DISC, NUMBERS };

typedef struct ray {
  const tp_wedge_law *law;
  arb_struct begins[TP_WEDGE_LINES], slopes[TP_WEDGE_LINES]; /* of lines, in t */
  arb_struct values[TP_WEDGE_LINES];                         /* at some t */
  arb_struct stops[CROSSINGS + 1]; /* 0, and where it crosses a line, in their order */
  int count;
  arb_struct n[NUMBERS];
  arf_t beyond; /* lines that may be along the ray are not crossed before that */
} ray;

static void each(ray *r, void (*what)(arb_t number)) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) {
    what(r->begins + k);
    what(r->slopes + k);
    what(r->values + k);
  }
  for (int k = 0; k <= CROSSINGS; k++) what(r->stops + k);
  for (int k = 0; k < NUMBERS; k++) what(r->n + k);
}

/* No root of from + t slope, as its slope may be zero, lies before |from| over the most of it. */
static void keep_before(ray *r, const arb_t from, const arb_t slope, const arb_t start) {
  arf_t least, most;
  arf_init(least);
  arf_init(most);
  arb_get_abs_lbound_arf(least, from, BITS);
  arb_get_abs_ubound_arf(most, slope, BITS);
  if (!arf_is_zero(most)) {
    arf_div(least, least, most, BITS, ARF_RND_DOWN);
    arb_get_lbound_arf(most, start, BITS);
    arf_add(least, least, most, BITS, ARF_RND_DOWN);
    arf_min(r->beyond, r->beyond, least);
  }
  arf_clear(least);
  arf_clear(most);
}

/* Where it crosses the lines of the ways, in order. */
static void set_stops(ray *r) {
  static const int lines[CROSSINGS] = {TP_WEDGE_NORMAL_A, TP_WEDGE_NORMAL_B, TP_WEDGE_PRESS_A,
                                       TP_WEDGE_PRESS_B};
  for (int k = 0; k < CROSSINGS; k++) {
    const arb_struct *from = r->begins + lines[k], *slope = r->slopes + lines[k];
    if (arb_contains_zero(slope)) {
      keep_before(r, from, slope, r->stops);
      continue;
    }
    arb_div(r->n + ROOT, from, slope, BITS);
    arb_neg(r->n + ROOT, r->n + ROOT);
    if (arb_is_negative(r->n + ROOT)) continue;
    int at = ++r->count;
    for (; at > 1 && arf_cmp(arb_midref(r->stops + at - 1), arb_midref(r->n + ROOT)) > 0; at--) {
      arb_set(r->stops + at, r->stops + at - 1);
    }
    arb_set(r->stops + at, r->n + ROOT);
  }
}

static void set_values(ray *r, const arb_t t) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) {
    arb_mul(r->values + k, r->slopes + k, t, BITS);
    arb_add(r->values + k, r->values + k, r->begins + k, BITS);
  }
}

/* The way between a stop and the next, or behind the last. */
static tp_wedge_way way_after(ray *r, int stop) {
  arb_struct *probe = r->n + PROBE;
  if (stop < r->count) {
    arb_add(probe, r->stops + stop, r->stops + stop + 1, BITS);
    arb_mul_2exp_si(probe, probe, -1);
  } else {
    arb_mul_2exp_si(probe, r->stops + stop, 1);
    arb_add_ui(probe, probe, 1, BITS);
  }
  arb_get_mid_arb(probe, probe);
  set_values(r, probe);
  return tp_wedge_way_of(r->values);
}

/* ---- roots -------------------------------------------------------------------------------------
 */

/* On both: strength less, or with, R . l, of the values at a start; the lesser root behind it. */
static bool find_root_on_both(ray *r, const arb_t start) {
  bool found = false;
  for (int up = 0; up < 2; up++) {
    arb_struct *from = r->n + A, *slope = r->n + B;
    tp_wedge_strength(from, r->law, TP_WEDGE_ON_BOTH, r->values, false);
    tp_wedge_strength(slope, r->law, TP_WEDGE_ON_BOTH, r->slopes, true);
    (up ? arb_sub : arb_add)(from, from, r->values + TP_WEDGE_ALONG, BITS);
    (up ? arb_sub : arb_add)(slope, slope, r->slopes + TP_WEDGE_ALONG, BITS);
    if (arb_is_nonnegative(slope)) continue;
    if (!arb_is_negative(slope)) {
      keep_before(r, from, slope, start);
      continue;
    }
    arb_div(r->n + C, from, slope, BITS);
    arb_neg(r->n + C, r->n + C);
    if (found) {
      arb_min(r->n + ROOT, r->n + ROOT, r->n + C, BITS);
    } else {
      arb_set(r->n + ROOT, r->n + C);
    }
    found = true;
  }
  return found;
}

/* The product of the values of two lines, of two kinds each, and of their parts across. */
static void set_product(arb_t product, const arb_struct *p, const arb_struct *q, int across) {
  arb_mul(product, p + TP_WEDGE_ALONG, q + TP_WEDGE_ALONG, BITS);
  arb_addmul(product, p + across, q + across, BITS);
}

/* On one joint: A t^2 + 2 B t + C = strength^2 - driving^2, with C > 0 at a start: the least root
 * behind it is C / (-B + sqrt(B^2 - A C)), where that is above zero. */
static bool find_root_on_one(ray *r, tp_wedge_way way, const arb_t start) {
  const int across = way == TP_WEDGE_ON_A ? TP_WEDGE_ACROSS_A : TP_WEDGE_ACROSS_B;
  arb_struct *n = r->n;
  tp_wedge_strength(n + LEFT, r->law, way, r->values, false);
  tp_wedge_strength(n + RIGHT, r->law, way, r->slopes, true);
  const arb_struct *const pairs[][4] = {{n + RIGHT, n + RIGHT, r->slopes, r->slopes},
                                        {n + LEFT, n + RIGHT, r->values, r->slopes},
                                        {n + LEFT, n + LEFT, r->values, r->values}};
  for (int k = 0; k < 3; k++) {
    set_product(n + DISC, pairs[k][2], pairs[k][3], across);
    arb_mul(n + A + k, pairs[k][0], pairs[k][1], BITS);
    arb_sub(n + A + k, n + A + k, n + DISC, BITS);
  }
  arb_mul(n + DISC, n + B, n + B, BITS);
  arb_submul(n + DISC, n + A, n + C, BITS);
  if (arb_is_negative(n + DISC)) return false;
  if (!arb_is_nonnegative(n + DISC)) arf_zero(r->beyond); /* may touch, may not */
  arb_sqrtpos(n + DISC, n + DISC, BITS);
  arb_sub(n + DISC, n + DISC, n + B, BITS);
  if (arb_is_nonpositive(n + DISC)) return false;
  if (!arb_is_positive(n + DISC)) {
    keep_before(r, n + C, n + DISC, start);
    return false;
  }
  arb_div(n + ROOT, n + C, n + DISC, BITS);
  return true;
}

/* Behind a stop where it stands, on the way that it goes there. */
static bool find_root(ray *r, tp_wedge_way way, const arb_t start) {
  const bool found =
      way == TP_WEDGE_ON_BOTH ? find_root_on_both(r, start) : find_root_on_one(r, way, start);
  if (found) arb_add(r->n + ROOT, r->n + ROOT, start, BITS);
  return found;
}

/* ---- the least ---------------------------------------------------------------------------------
 */

typedef enum answer { GOES_ON, ENDS, OPEN } answer;

/* On the stretch behind a stop. */
static answer look_after(arb_t reach, ray *r, int stop, tp_wedge_way way) {
  const arb_struct *start = r->stops + stop;
  arb_set(reach, start);
  if (way == TP_WEDGE_UNKNOWN) return OPEN;
  if (way == TP_WEDGE_ON_NONE) return ENDS;
  set_values(r, start);
  tp_wedge_strength(r->n + LEFT, r->law, way, r->values, false);
  tp_wedge_driving(r->n + RIGHT, way, r->values);
  if (arb_lt(r->n + LEFT, r->n + RIGHT)) return ENDS;
  if (!arb_gt(r->n + LEFT, r->n + RIGHT)) return OPEN;
  if (!find_root(r, way, start)) return GOES_ON;
  arb_set(reach, r->n + ROOT);
  if (stop == r->count || arb_lt(reach, start + 1)) return ENDS;
  return arb_gt(reach, start + 1) ? GOES_ON : OPEN;
}

static bool find(arb_t reach, tp_wedge_way *way, ray *r) {
  for (int stop = 0; stop <= r->count; stop++) {
    if (stop < r->count && arb_overlaps(r->stops + stop, r->stops + stop + 1)) {
      arb_union(r->stops + stop + 1, r->stops + stop, r->stops + stop + 1, BITS);
      continue;
    }
    *way = way_after(r, stop);
    const answer own = look_after(reach, r, stop, *way);
    if (own == GOES_ON) continue;
    arb_get_ubound_arf(arb_midref(r->n + PROBE), reach, BITS);
    return own == ENDS && arb_is_positive(reach) &&
           arf_cmp(arb_midref(r->n + PROBE), r->beyond) < 0;
  }
  return false;
}

bool tp_wedge_reach(arb_t reach, tp_wedge_way *way, const tp_wedge_law *law, const arb_t east,
                    const arb_t north) {
  ray r = {.law = law};
  each(&r, arb_init);
  arf_init(r.beyond);
  arf_pos_inf(r.beyond);
  tp_wedge_values(r.slopes, law, east, north, true);
  for (int k = 0; k < TP_WEDGE_LINES; k++) arb_set(r.begins + k, law->lines[k]);
  set_stops(&r);
  const bool found = find(reach, way, &r);
  each(&r, arb_clear);
  arf_clear(r.beyond);
  return found;
}
