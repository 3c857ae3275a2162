/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Can a mode begin with a share of its strength, or with none of an interval? Each choice of three
 * lines is asked in doubles with bounds. */

#include "motion/share_mode.h"

bool tp_share_choice_is_flat(const tp_share_mode *m, const int of[3]) {
  const tp_share_line *a = m->of[of[0]], *b = m->of[of[1]], *c = m->of[of[2]];
  const bool site = a->site != 0 && a->site == b->site && a->site == c->site;
  const bool parallel =
      a->parallel != 0 && a->parallel == b->parallel && a->parallel == c->parallel;
  return m->ray_count > 0 && (site || parallel);
}

bool tp_share_choice_next(tp_share_choice *c, const tp_share_mode *m) {
  const int all = m->count + m->free_count;
  unsigned free = 0; /* those among the three have no bound */
  for (int k = 0; k < 3; k++) {
    if (tp_share_choice_is_free(m, c->of[k])) free |= 1U << (c->of[k] - m->count);
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

/* ---- at one share, or in an interval of it -----------------------------------------------------
 */

static void evaluate_line(tp_near own[3], const tp_share_line *line, tp_near share) {
  for (int e = 0; e < 3; e++) {
    own[e] = line->rise[e].value == 0 && line->rise[e].error == 0
                 ? line->at[e]
                 : tp_near_add(line->at[e], tp_near_mul(line->rise[e], share));
  }
}

void tp_share_values_at(tp_share_values *own, const tp_share_mode *m, tp_near share) {
  evaluate_line(own->loads, &m->loads, share);
  for (int k = 0; k < m->count + m->free_count; k++) evaluate_line(own->of[k], m->of[k], share);
}

/* What is left to the three. */
static void left_to(tp_near w[3], const tp_share_values *at, const tp_share_mode *m,
                    const tp_share_choice *c) {
  for (int e = 0; e < 3; e++) w[e] = at->loads[e];
  for (int k = m->count; k < m->count + m->free_count; k++) {
    if (k == c->of[0] || k == c->of[1] || k == c->of[2]) continue;
    const bool turned = (c->bounds >> (k - m->count) & 1U) == 0;
    for (int e = 0; e < 3; e++) w[e] = (turned ? tp_near_sub : tp_near_add)(w[e], at->of[k][e]);
  }
}

int tp_share_choice_side(const tp_share_mode *m, const tp_share_values *at,
                         const tp_share_choice *c) {
  tp_near w[3];
  left_to(w, at, m, c);
  const tp_near *g[3] = {at->of[c->of[0]], at->of[c->of[1]], at->of[c->of[2]]};
  const tp_near whole = tp_near_determinant(g[0], g[1], g[2]);
  const int turn = tp_near_sign(whole);
  if (turn == 0) return 0;
  int all = 1;
  for (int k = 0; k < 3; k++) {
    const tp_near part = tp_near_determinant(w, g[(k + 1) % 3], g[(k + 2) % 3]);
    int side = turn * tp_near_sign(part);
    if (tp_share_choice_is_free(m, c->of[k])) {
      const int below = turn * tp_near_sign(tp_near_sub(whole, part));
      const int above = turn * tp_near_sign(tp_near_add(whole, part));
      side = below < above ? below : above;
    }
    if (side < 0) return -1;
    if (side == 0) all = 0;
  }
  return all;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

/* One generator or two are no sum of anything off their line or plane. */
static int side_of_flat(const tp_share_mode *m, tp_near share) {
  tp_near w[3], g[2][3], cross[3];
  if (m->free_count > 0 || m->count <= 0) return 0;
  evaluate_line(w, &m->loads, share);
  for (int k = 0; k < m->count; k++) evaluate_line(g[k], m->of[k], share);
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
  tp_share_choice c = {.of = {0, 1, 2}};
  tp_share_values at;
  tp_share_values_at(&at, m, s);
  int any = -1;
  do {
    if (tp_share_choice_is_flat(m, c.of)) continue;
    const int side = tp_share_choice_side(m, &at, &c);
    if (side > 0) return 1;
    if (side == 0) any = 0;
  } while (tp_share_choice_next(&c, m));
  return any;
}
