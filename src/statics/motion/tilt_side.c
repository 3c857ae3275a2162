/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* f = A cos a + B sin a + C over a span of tilts between -90 and 90 degrees.
 *
 * Its slope g = B cos a - A sin a changes its sign once at most within half a turn. So f has its
 * least value over the span at an end of it, unless g goes from below zero to above: then that is
 * C - R at least, R = |(A, B)|. For its largest value the same holds of -f. Signs are those of
 * doubles beyond their bounds (number/near.h). */

#include "motion/tilt_side.h"

#include "number/ball.h"
#include "number/near_angle.h"

/* A, B and C. */
typedef struct wave {
  tp_near cosine, sine, constant;
} wave;

static tp_near near_of(const arb_t ball) {
  return arb_is_zero(ball) ? (tp_near){0, 0} : tp_ball_near(ball);
}

/* f and its slope at an end. */
static void evaluate(tp_near *value, tp_near *slope, const wave *f, const tp_tilt *end,
                     double upright) {
  const tp_near degrees = end->endless ? (tp_near){upright, 0} : tp_ball_near(end->degrees);
  tp_near sine, cosine;
  tp_near_sin_cos(&sine, &cosine, degrees);
  *value = tp_near_plus(
      tp_near_plus(tp_near_times(f->cosine, cosine), tp_near_times(f->sine, sine)), f->constant);
  *slope = tp_near_minus(tp_near_times(f->sine, cosine), tp_near_times(f->cosine, sine));
}

/* Is C beyond R, on this side of zero? */
static bool is_beyond(const wave *f, int side) {
  const tp_near squares =
      tp_near_plus(tp_near_times(f->cosine, f->cosine), tp_near_times(f->sine, f->sine));
  const tp_near square = tp_near_times(f->constant, f->constant);
  return tp_near_sign(f->constant) == side && tp_near_sign(tp_near_minus(square, squares)) > 0;
}

/* 1, -1, or 0. */
static int side_on(const wave *f, const tp_tilt_span *span) {
  tp_near from, to, slope_from, slope_to;
  evaluate(&from, &slope_from, f, &span->from, -90);
  evaluate(&to, &slope_to, f, &span->to, 90);
  const int side = tp_near_sign(from);
  if (side == 0 || tp_near_sign(to) != side) return 0;
  const bool at_ends = side * tp_near_sign(slope_from) > 0 || side * tp_near_sign(slope_to) < 0;
  return at_ends || is_beyond(f, side) ? side : 0;
}

tp_answer tp_tilts_side(const tp_motion_tilts *spans, const tp_trig *f) {
  if (!arb_is_zero(f->of + TP_SEC) || !arb_is_zero(f->of + TP_SEC2)) return TP_OPEN;
  const wave own = {near_of(f->of + TP_COS), near_of(f->of + TP_SIN), near_of(f->of + TP_ONE)};
  int all = 0;
  for (long k = 0; k < spans->count; k++) {
    const int side = side_on(&own, spans->items + k);
    if (side == 0 || (k > 0 && side != all)) return TP_OPEN;
    all = side;
  }
  return all > 0 ? TP_YES : all < 0 ? TP_NO : TP_OPEN;
}
