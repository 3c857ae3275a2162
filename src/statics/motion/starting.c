/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads as a sum of three generators by Cramer's rule in balls, with every choice of bounds for the
 * free forces; sums within their bounds are motions of the mode (docs/mechanics.md section 6a). */

#include "motion/starting.h"

/* w = f_0 g_0 + f_1 g_1 + f_2 g_2 by Cramer's rule. TP_NO: they span no space. */
static tp_answer solve(arb_ptr factors, const tp_starting *s, const long of[3]) {
  const long bits = s->q->judge.precision;
  const tp_vector *g[3] = {s->items + of[0], s->items + of[1], s->items + of[2]};
  tp_vector cross;
  arb_t whole;
  tp_vector_init(&cross);
  arb_init(whole);
  double scale = 0;
  for (int k = 0; k < 3; k++) scale += tp_vector_log2_size(g[k]);
  tp_vector_cross(&cross, g[1], g[2], bits);
  tp_vector_dot(whole, &cross, g[0], bits);
  const int sign = tp_judge_sign(&s->q->judge, whole, scale);
  for (int k = 0; k < 3 && (sign == 1 || sign == -1); k++) {
    tp_vector_cross(&cross, g[(k + 1) % 3], g[(k + 2) % 3], bits);
    tp_vector_dot(factors + k, &cross, &s->rest, bits);
    arb_div(factors + k, factors + k, whole, s->q->judge.bits);
  }
  tp_vector_clear(&cross);
  arb_clear(whole);
  return sign == TP_OPEN_SIGN ? TP_OPEN : sign == 0 ? TP_NO : TP_YES;
}

/* Sign of a factor, or of what is left of a free one to its bound. */
static int sign_of(const tp_starting *s, const arb_t factor, bool is_free) {
  if (!is_free) return tp_judge_sign(&s->q->judge, factor, 0);
  arb_t left;
  arb_init(left);
  arb_abs(left, factor);
  arb_sub_ui(left, left, 1, s->q->judge.bits);
  arb_neg(left, left);
  const int sign = tp_judge_sign(&s->q->judge, left, 0);
  arb_clear(left);
  return sign;
}

/* Is every factor within its bounds, and are all rays at work? */
static tp_answer is_motion(arb_srcptr factors, const tp_starting *s, const long of[3]) {
  int rays = 0;
  for (int k = 0; k < 3; k++) {
    const int sign = sign_of(s, factors + k, of[k] >= s->count);
    if (sign == TP_OPEN_SIGN) return TP_OPEN;
    if (sign < 0) return TP_NO;
    if (of[k] < s->mode->ray_count && sign > 0) rays++;
  }
  return rays == s->mode->ray_count ? TP_YES : TP_NO;
}

static void keep(tp_starting *s, arb_srcptr factors, const long of[3]) {
  const long bits = s->q->judge.bits;
  tp_start *start = s->start;
  arb_t sum;
  arb_init(sum);
  for (int k = 0; k < 3; k++) {
    if (of[k] < s->mode->ray_count) arb_add(sum, sum, factors + k, bits);
  }
  const int order = arf_cmp(arb_midref(sum), arb_midref(s->best));
  const bool best = s->solutions == 0 || (s->greatest ? order > 0 : order < 0);
  s->solutions++;
  if (best) {
    arb_set(s->best, sum);
    for (int e = 0; e < 3; e++) arb_zero(start->twist.of + e);
    _arb_vec_zero(start->forces, start->force_count);
    for (int k = 0; k < 3; k++) {
      if (of[k] >= s->count) continue;
      if (of[k] >= s->mode->ray_count) {
        arb_set(start->forces + of[k] - s->mode->ray_count, factors + k);
        continue;
      }
      const tp_vector *twist = &s->m->twists.rays[s->mode->rays[of[k]]].twist;
      for (int e = 0; e < 3; e++) {
        arb_addmul(start->twist.of + e, twist->of + e, factors + k, bits);
      }
    }
  }
  arb_clear(sum);
}

/* The loads with each free force that is none of the three at its bound: bit k tells which. */
static void set_rest(tp_starting *s, unsigned bounds, const long of[3]) {
  const long bits = s->q->judge.bits;
  for (int e = 0; e < 3; e++) arb_set(s->rest.of + e, s->loads.of + e);
  for (long k = 0; k < s->free_count; k++) {
    const long own = s->count + k;
    if (of[0] == own || of[1] == own || of[2] == own) continue;
    for (int e = 0; e < 3; e++) {
      arb_struct *rest = s->rest.of + e;
      const arb_struct *force = s->items[own].of + e;
      if ((bounds >> k & 1U) != 0) {
        arb_add(rest, rest, force, bits);
      } else {
        arb_sub(rest, rest, force, bits);
      }
    }
  }
}

/* Three generators with free forces at every choice of their bounds; of those that are among the
 * three it makes no difference. */
static tp_answer try_three(tp_starting *s, arb_ptr factors, const long of[3]) {
  unsigned among = 0;
  for (int k = 0; k < 3; k++) {
    if (of[k] >= s->count) among |= 1U << (of[k] - s->count);
  }
  tp_answer answer = TP_YES;
  for (unsigned bounds = 0; bounds < 1U << s->free_count && answer != TP_OPEN; bounds++) {
    if ((bounds & among) != 0) continue;
    set_rest(s, bounds, of);
    answer = solve(factors, s, of);
    if (answer == TP_YES) answer = is_motion(factors, s, of);
    if (answer == TP_YES) keep(s, factors, of);
  }
  return answer;
}

/* All rays of the mode are at work: they are among the three. */
tp_motion_outcome tp_starting_try(tp_starting *s) {
  arb_struct *factors = _arb_vec_init(3);
  tp_answer answer = TP_YES;
  const long all = s->count + s->free_count;
  const long end = s->mode->ray_count == 2 ? 2 : all;
  long of[3] = {0};
  for (of[1] = 1; of[1] < end && answer != TP_OPEN; of[1]++) {
    for (of[2] = of[1] + 1; of[2] < all && answer != TP_OPEN; of[2]++) {
      answer = try_three(s, factors, of);
    }
  }
  _arb_vec_clear(factors, 3);
  return answer == TP_OPEN ? TP_MOTION_OPEN : TP_MOTION_PROVEN;
}
