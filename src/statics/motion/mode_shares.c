/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The signs of determinants of three generators give the shares at which a mode can begin
 * (docs/mechanics.md section 6, factor of the onset). */

#include "motion/mode_shares.h"

#include "number/ball.h"

#include <math.h>

static void add_line(tp_share_line *sum, const tp_share_line *other, bool turned) {
  for (int e = 0; e < 3; e++) {
    const tp_near at = turned ? tp_near_neg(other->at[e]) : other->at[e];
    const tp_near rise = turned ? tp_near_neg(other->rise[e]) : other->rise[e];
    sum->at[e] = tp_near_add(sum->at[e], at);
    sum->rise[e] = tp_near_add(sum->rise[e], rise);
  }
}

static void add_balls(tp_ball_line *sum, const tp_ball_line *other, bool turned, long bits) {
  for (int e = 0; e < 3; e++) {
    (turned ? arb_sub : arb_add)(sum->at.of + e, sum->at.of + e, other->at.of + e, bits);
    (turned ? arb_sub : arb_add)(sum->rise.of + e, sum->rise.of + e, other->rise.of + e, bits);
  }
}

/* What is left to the three; `room` for that. */
static const tp_share_line *loads_of(tp_share_line *room, const tp_share_mode *m,
                                     const tp_share_choice *c) {
  if (m->free_count == 0) return &m->loads;
  *room = m->loads;
  if (m->sum != NULL) {
    for (int e = 0; e < 3; e++) {
      arb_set(m->sum->at.of + e, m->loads.balls->at.of + e);
      arb_set(m->sum->rise.of + e, m->loads.balls->rise.of + e);
    }
    room->balls = m->sum;
  }
  for (int k = 0; k < m->free_count; k++) {
    const int own = m->count + k;
    if (own == c->of[0] || own == c->of[1] || own == c->of[2]) continue;
    const bool turned = (c->bounds >> k & 1U) == 0;
    add_line(room, m->of[own], turned);
    if (m->sum != NULL) add_balls(m->sum, m->of[own]->balls, turned, m->bits);
  }
  return room;
}

/* det(w, g_i, g_j) of two generators, and its sign at all shares that matter, 0 where these differ
 * or all matter. */
typedef struct part {
  tp_share_polynomial of;
  int sign;
} part;

/* Where nothing is free: the same for all choices that have both. */
typedef struct pair_parts {
  double ratio;                       /* shares matter from its inverse to it */
  unsigned known[TP_SHARE_ALL_LINES]; /* bit j of the i-th */
  part of[TP_SHARE_ALL_LINES][TP_SHARE_ALL_LINES];
} pair_parts;

static int sign_of(const tp_share_polynomial *p, double ratio) {
  return ratio < INFINITY ? tp_share_polynomial_sign(p, 1 / ratio, ratio) : 0;
}

static const part *part_of(pair_parts *parts, const tp_share_mode *m, const tp_share_line *loads,
                           int i, int j) {
  part *own = &parts->of[i][j];
  const unsigned bit = 1U << j;
  if (m->free_count > 0 || (parts->known[i] & bit) == 0) {
    own->of = tp_share_determinant(loads, m->of[i], m->of[j], m->bits);
    own->sign = sign_of(&own->of, parts->ratio);
    parts->known[i] |= bit;
  }
  return own;
}

/* The parts of a choice; false where two of generators differ in sign at all shares that matter. */
static bool find_parts(const part *own[3], pair_parts *parts, const tp_share_mode *m,
                       const tp_share_choice *c) {
  tp_share_line room;
  const tp_share_line *loads = loads_of(&room, m, c);
  int sign = 0;
  for (int k = 0; k < 3; k++) {
    own[k] = part_of(parts, m, loads, c->of[(k + 1) % 3], c->of[(k + 2) % 3]);
    if (tp_share_choice_is_free(m, c->of[k])) continue;
    if (sign * own[k]->sign < 0) return false;
    if (sign == 0) sign = own[k]->sign;
  }
  return true;
}

static bool add_choice(tp_share_spans *spans, const tp_share_mode *m, const tp_share_choice *own,
                       pair_parts *parts) {
  const tp_share_line *g[3] = {m->of[own->of[0]], m->of[own->of[1]], m->of[own->of[2]]};
  const part *of[3];
  if (!find_parts(of, parts, m, own)) return true;
  const tp_share_polynomial whole = tp_share_determinant(g[0], g[1], g[2], m->bits);
  if (whole.degree < 0) return true;
  const int sign = sign_of(&whole, parts->ratio);
  tp_share_conditions c = {.count = 0};
  for (int k = 0; k < 3; k++) {
    const tp_share_polynomial *own_part = &of[k]->of;
    tp_share_polynomial *to = c.of[c.count++];
    to[0] = *own_part;
    to[1] = whole;
    if (!tp_share_choice_is_free(m, own->of[k])) {
      if (sign * of[k]->sign < 0) return true;
      continue;
    }
    for (int e = 0; e <= TP_SHARE_DEGREE; e++) { /* from -1 to 1 */
      to[0].of[e] = whole.of[e] - own_part->of[e];
      to[1].of[e] = whole.of[e] + own_part->of[e];
    }
    to[0].degree = to[1].degree = whole.degree > own_part->degree ? whole.degree : own_part->degree;
  }
  return tp_share_spans_where(spans, &c, m->mechanism);
}

static tp_share_polynomial work_of(const tp_share_line *loads, const tp_near h[3]) {
  const tp_near level = tp_near_dot(h, loads->at), rise = tp_near_dot(h, loads->rise);
  tp_share_polynomial p = {.of = {level.value, tp_near_sign(rise) != 0 ? rise.value : 0}};
  p.degree = p.of[1] != 0 ? 1 : 0;
  return p;
}

/* Half-spaces, of which each is a condition: the spans that all leave. */
static bool add_interior(tp_share_spans *spans, const tp_share_mode *m) {
  double low = TP_LEAST_SHARE, high = TP_MOST_SHARE;
  for (long k = 0; k < m->plane_count; k++) {
    const tp_share_polynomial p = work_of(&m->loads, m->planes[k].at);
    if (p.degree == 0) {
      if (p.of[0] < 0) return true;
      continue;
    }
    const double zero = -p.of[0] / p.of[1];
    if (p.of[1] > 0) {
      low = fmax(low, zero);
    } else {
      high = fmin(high, zero);
    }
  }
  return low >= high || tp_share_spans_put(spans, (tp_share_span){low, high, m->mechanism});
}

bool tp_share_spans_add(tp_share_spans *spans, const tp_share_mode *m) {
  return tp_share_spans_add_near(spans, m, INFINITY);
}

static tp_near from_inverse_to(double ratio) {
  const double half = (ratio - 1 / ratio) / 2;
  return tp_near_of(1 / ratio + half, half + 4 * ratio * DBL_EPSILON);
}

/* Up to this ratio the lines, each with all of its values there, rule out nearly all choices for
 * less than the polynomials take. */
static const double narrow = 1.125;

bool tp_share_spans_add_near(tp_share_spans *spans, const tp_share_mode *m, double ratio) {
  if (m->interior) return add_interior(spans, m);
  if (m->count + m->free_count < 3) return true; /* they span no solid */
  tp_share_choice c = {.of = {0, 1, 2}};
  pair_parts parts;
  parts.ratio = ratio;
  tp_share_values near_one;
  const bool is_near = ratio < narrow;
  if (is_near) tp_share_values_at(&near_one, m, from_inverse_to(ratio));
  for (int k = 0; k < m->count + m->free_count; k++) parts.known[k] = 0;
  do {
    if (tp_share_choice_is_flat(m, c.of)) continue;
    if (is_near && tp_share_choice_side(m, &near_one, &c) < 0) continue;
    if (!add_choice(spans, m, &c, &parts)) return false;
  } while (tp_share_choice_next(&c, m));
  return true;
}
