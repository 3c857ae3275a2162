/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An anchor: a force of fixed size and direction in the block's frame, at a point of the block. */

#include "load/setting.h"

#include "number/ball.h"

void tp_load_anchor(tp_wrench *wrench, const tp_anchor_description *anchor,
                    const tp_load_setting *s) {
  tp_trig fx, fy;
  arb_t x, y, force;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(x);
  arb_init(y);
  arb_init(force);
  tp_ball_sin_cos_degrees(fy.of + TP_ONE, fx.of + TP_ONE, anchor->direction_deg.value, s->bits);
  if (s->mirrored) arb_neg(fx.of + TP_ONE, fx.of + TP_ONE);
  arb_set_fmpq(force, anchor->force_kn.value, s->bits);
  arb_mul_ui(force, force, TP_KILO, s->bits);
  arb_mul(fx.of + TP_ONE, fx.of + TP_ONE, force, s->bits);
  arb_mul(fy.of + TP_ONE, fy.of + TP_ONE, force, s->bits);
  tp_load_point(x, y, &anchor->x, &anchor->y, s);
  tp_wrench_add_force(wrench, &fx, &fy, x, y, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(x);
  arb_clear(y);
  arb_clear(force);
}
