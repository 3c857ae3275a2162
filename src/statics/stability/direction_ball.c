/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Order of two critical angles by disjoint balls, or by the sign of the exact cross product of
 * their directions; what remains unresolved at enough bits is a tie (docs/mechanics.md section
 * 10). */

#include "stability/direction_ball.h"

void tp_direction_ball_init(tp_direction_ball *angle) {
  arb_init(angle->sine);
  arb_init(angle->cosine);
  arb_init(angle->degrees);
  arb_init(angle->inclination);
  angle->exact_direction = false;
  angle->adds = NULL;
}

void tp_direction_ball_clear(tp_direction_ball *angle) {
  arb_clear(angle->sine);
  arb_clear(angle->cosine);
  arb_clear(angle->degrees);
  arb_clear(angle->inclination);
}

/* Sign of sin(a - b), which is that of a - b for angles less than half a turn apart. */
static bool cross_sign(const tp_direction_ball *a, const tp_direction_ball *b, int *sign) {
  arb_t cross;
  arb_init(cross);
  arb_mul(cross, a->sine, b->cosine, ARF_PREC_EXACT);
  arb_submul(cross, b->sine, a->cosine, ARF_PREC_EXACT);
  const bool decided = arb_is_exact(cross) || !arb_contains_zero(cross);
  *sign = arf_sgn(arb_midref(cross));
  arb_clear(cross);
  return decided;
}

tp_angle_order tp_direction_ball_order(const tp_evaluation *e, const tp_direction_ball *a,
                                       const tp_direction_ball *b, tp_certainty *certainty) {
  if (arb_lt(a->degrees, b->degrees)) return (tp_angle_order){.sign = -1};
  if (arb_gt(a->degrees, b->degrees)) return (tp_angle_order){.sign = 1};
  int sign = 0;
  if (arb_is_exact(a->degrees) && arb_is_exact(b->degrees)) return (tp_angle_order){.sign = 0};
  if (e->rung.level == TP_LEVEL_EXACT && a->exact_direction && b->exact_direction &&
      cross_sign(a, b, &sign)) {
    return (tp_angle_order){.sign = sign};
  }
  if (!tp_is_settled(e, a->degrees) || !tp_is_settled(e, b->degrees)) certainty->open = true;
  return (tp_angle_order){.sign = 0, .tie_bits = e->rung.bits};
}

int tp_direction_ball_compare(const tp_evaluation *e, const tp_direction_ball *a,
                              const tp_direction_ball *b, tp_certainty *certainty) {
  tp_certainty own = {0};
  const tp_angle_order order = tp_direction_ball_order(e, a, b, &own);
  if (order.tie_bits != 0 && !own.open) tp_certainty_take_zero(&own, e);
  tp_certainty_add(certainty, &own);
  return order.sign;
}
