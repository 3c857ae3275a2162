/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The signs of determinants of three generators give the shares at which a mode can begin
 * (docs/mechanics.md section 6, factor of the onset). */

#include "motion/mode_shares.h"

#include "number/ball.h"

#include <math.h>
#include <string.h>

/* Three of the generators and of what is free, the rest of that at its bounds. */
typedef struct choice {
  int of[3];
  unsigned bounds; /* bit k: the k-th of what is free, not among the three, is at 1, else at -1 */
} choice;

static bool is_free(const tp_share_mode *m, int k) {
  return k >= m->count;
}

/* Forces through one point, or along one direction, span no solid; with a ray each two of them do.
 */
static bool is_flat(const tp_share_mode *m, const int of[3]) {
  const tp_share_line *a = m->of + of[0], *b = m->of + of[1], *c = m->of + of[2];
  const bool site = a->site != 0 && a->site == b->site && a->site == c->site;
  const bool parallel =
      a->parallel != 0 && a->parallel == b->parallel && a->parallel == c->parallel;
  return m->ray_count > 0 && (site || parallel);
}

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

/* What is left to the three. */
static tp_share_line loads_of(const tp_share_mode *m, const choice *c) {
  tp_share_line loads = m->loads;
  if (m->sum != NULL) {
    for (int e = 0; e < 3; e++) {
      arb_set(m->sum->at.of + e, loads.balls->at.of + e);
      arb_set(m->sum->rise.of + e, loads.balls->rise.of + e);
    }
    loads.balls = m->sum;
  }
  for (int k = 0; k < m->free_count; k++) {
    const int own = m->count + k;
    if (own == c->of[0] || own == c->of[1] || own == c->of[2]) continue;
    const bool turned = (c->bounds >> k & 1U) == 0;
    add_line(&loads, m->of + own, turned);
    if (m->sum != NULL) add_balls(m->sum, m->of[own].balls, turned, m->bits);
  }
  return loads;
}

/* The next choice: sets of three in their order, each with all bounds. */
static bool next_choice(choice *c, const tp_share_mode *m) {
  const int all = m->count + m->free_count;
  unsigned free = 0; /* those among the three have no bound */
  for (int k = 0; k < 3; k++) {
    if (is_free(m, c->of[k])) free |= 1U << (c->of[k] - m->count);
  }
  for (c->bounds++; c->bounds < 1U << m->free_count; c->bounds++) {
    if ((c->bounds & free) == 0) return true;
  }
  c->bounds = 0;
  int k = 2;
  while (k >= 0 && c->of[k] == all - 3 + k) k--;
  if (k < 0) return false;
  c->of[k]++;
  for (k++; k < 3; k++) c->of[k] = c->of[k - 1] + 1;
  return true;
}

enum { LINES = TP_SHARE_LINES + TP_SHARE_FREE };

/* det(w, g_i, g_j) of two generators, where nothing is free: the same for all choices that have
 * both. */
typedef struct pair_parts {
  bool known[LINES][LINES];
  tp_share_polynomial of[LINES][LINES];
} pair_parts;

static tp_share_polynomial part_of(pair_parts *parts, const tp_share_mode *m,
                                   const tp_share_line *loads, int i, int j) {
  if (m->free_count > 0) return tp_share_determinant(loads, m->of + i, m->of + j, m->bits);
  tp_share_polynomial *own = &parts->of[i][j];
  if (!parts->known[i][j]) *own = tp_share_determinant(loads, m->of + i, m->of + j, m->bits);
  parts->known[i][j] = true;
  return *own;
}

/* The parts of a choice; false where two differ in sign at all shares that matter. */
static bool find_parts(tp_share_polynomial part[3], pair_parts *parts, const tp_share_mode *m,
                       const choice *own, double ratio) {
  const tp_share_line loads = loads_of(m, own);
  const bool rejects = ratio < INFINITY && !is_free(m, own->of[2]);
  for (int k = 0; k < 3; k++) {
    part[k] = part_of(parts, m, &loads, own->of[(k + 1) % 3], own->of[(k + 2) % 3]);
    for (int before = 0; before < k && rejects; before++) {
      if (tp_share_polynomials_oppose(part + before, part + k, 1 / ratio, ratio)) return false;
    }
  }
  return true;
}

static bool add_choice(tp_share_spans *spans, const tp_share_mode *m, const choice *own,
                       double ratio, pair_parts *parts) {
  const tp_share_line *g[3] = {m->of + own->of[0], m->of + own->of[1], m->of + own->of[2]};
  tp_share_polynomial part[3];
  if (!find_parts(part, parts, m, own, ratio)) return true;
  const tp_share_polynomial whole = tp_share_determinant(g[0], g[1], g[2], m->bits);
  tp_share_conditions c = {.count = 0};
  if (whole.degree < 0) return true;
  for (int k = 0; k < 3; k++) {
    tp_share_polynomial *to = c.of[c.count++];
    to[0] = part[k];
    to[1] = whole;
    if (!is_free(m, own->of[k])) {
      if (ratio < INFINITY && tp_share_polynomials_oppose(to, to + 1, 1 / ratio, ratio))
        return true;
      continue;
    }
    for (int e = 0; e <= TP_SHARE_DEGREE; e++) { /* from -1 to 1 */
      to[0].of[e] = whole.of[e] - part[k].of[e];
      to[1].of[e] = whole.of[e] + part[k].of[e];
    }
    to[0].degree = to[1].degree = whole.degree > part[k].degree ? whole.degree : part[k].degree;
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

bool tp_share_spans_add_near(tp_share_spans *spans, const tp_share_mode *m, double ratio) {
  if (m->interior) return add_interior(spans, m);
  if (m->count + m->free_count < 3) return true; /* they span no solid */
  choice c = {.of = {0, 1, 2}};
  pair_parts parts;
  for (int k = 0; k < m->count; k++) memset(parts.known[k], 0, (size_t)m->count);
  do {
    if (!is_flat(m, c.of) && !add_choice(spans, m, &c, ratio, &parts)) return false;
  } while (next_choice(&c, m));
  return true;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

static void evaluate_line(tp_near own[3], const tp_share_line *line, tp_near share) {
  for (int e = 0; e < 3; e++) {
    own[e] = line->rise[e].value == 0 && line->rise[e].error == 0
                 ? line->at[e]
                 : tp_near_add(line->at[e], tp_near_mul(line->rise[e], share));
  }
}

/* The loads as a sum of three: 1, or -1: they are none; 0 where it is open. */
static int side_of_choice(const tp_share_mode *m, const choice *c, tp_near share) {
  const tp_share_line loads = loads_of(m, c);
  tp_near w[3], g[3][3];
  evaluate_line(w, &loads, share);
  for (int k = 0; k < 3; k++) evaluate_line(g[k], m->of + c->of[k], share);
  const tp_near whole = tp_near_determinant(g[0], g[1], g[2]);
  const int turn = tp_near_sign(whole);
  if (turn == 0) return 0;
  int all = 1;
  for (int k = 0; k < 3; k++) {
    const tp_near part = tp_near_determinant(w, g[(k + 1) % 3], g[(k + 2) % 3]);
    int side = turn * tp_near_sign(part);
    if (is_free(m, c->of[k])) {
      const int below = turn * tp_near_sign(tp_near_sub(whole, part));
      const int above = turn * tp_near_sign(tp_near_add(whole, part));
      side = below < above ? below : above;
    }
    if (side < 0) return -1;
    if (side == 0) all = 0;
  }
  return all;
}

/* One generator or two are no sum of anything off their line or plane. */
static int side_of_flat(const tp_share_mode *m, tp_near share) {
  tp_near w[3], g[2][3], cross[3];
  if (m->free_count > 0 || m->count <= 0) return 0;
  evaluate_line(w, &m->loads, share);
  for (int k = 0; k < m->count; k++) evaluate_line(g[k], m->of + k, share);
  if (m->count == 2) return tp_near_sign(tp_near_determinant(w, g[0], g[1])) != 0 ? -1 : 0;
  tp_near_cross(cross, w, g[0]);
  for (int e = 0; e < 3; e++) {
    if (tp_near_sign(cross[e]) != 0) return -1;
  }
  return 0;
}

static int side_of_interior(const tp_share_mode *m, tp_near share) {
  tp_near w[3];
  evaluate_line(w, &m->loads, share);
  int all = 1;
  for (long k = 0; k < m->plane_count; k++) {
    const int side = tp_near_sign(tp_near_dot(m->planes[k].at, w));
    if (side < 0) return -1;
    if (side == 0) all = 0;
  }
  return all;
}

int tp_share_mode_side(const tp_share_mode *m, double share) {
  const tp_near s = {share, 0};
  if (m->interior) return side_of_interior(m, s);
  if (m->count + m->free_count < 3) return side_of_flat(m, s);
  choice c = {.of = {0, 1, 2}};
  int any = -1;
  do {
    if (is_flat(m, c.of)) continue;
    const int side = side_of_choice(m, &c, s);
    if (side > 0) return 1;
    if (side == 0) any = 0;
  } while (next_choice(&c, m));
  return any;
}
