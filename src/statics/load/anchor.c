/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An anchor: a force of fixed size and direction in the block's frame, at a point of the block; of
 * bolts at a spacing what a row bears on the whole thickness. */

#include "load/setting.h"

#include "number/ball.h"
#include "scene/anchor.h"

/* Of its pull, a length of one: as its angle says, or towards its far end. */
static void set_direction(arb_t fx, arb_t fy, const tp_anchor_description *anchor,
                          const tp_load_setting *s) {
  fmpq_t number;
  arb_t length;
  fmpq_init(number);
  arb_init(length);
  if (anchor->to_x.given) {
    fmpq_sub(number, anchor->to_x.value, anchor->x.value);
    arb_set_fmpq(fx, number, s->bits);
    fmpq_sub(number, anchor->to_y.value, anchor->y.value);
    arb_set_fmpq(fy, number, s->bits);
    arb_hypot(length, fx, fy, s->bits);
    arb_div(fx, fx, length, s->bits);
    arb_div(fy, fy, length, s->bits);
  } else {
    tp_anchor_direction(number, s->scene, anchor);
    tp_ball_sin_cos_degrees(fy, fx, number, s->bits);
  }
  if (s->mirrored) arb_neg(fx, fx);
  fmpq_clear(number);
  arb_clear(length);
}

void tp_load_anchor(tp_wrench *wrench, const tp_anchor_description *anchor, long row,
                    const tp_load_setting *s) {
  fmpq_t number;
  tp_quantity at[2];
  tp_trig fx, fy;
  arb_t x, y, force;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(x);
  arb_init(y);
  arb_init(force);
  fmpq_init(number);
  fmpq_init(at[0].value);
  fmpq_init(at[1].value);
  set_direction(fx.of + TP_ONE, fy.of + TP_ONE, anchor, s);
  tp_anchor_row_force(number, s->scene, anchor);
  arb_set_fmpq(force, number, s->bits);
  arb_mul_ui(force, force, TP_KILO, s->bits);
  arb_mul(fx.of + TP_ONE, fx.of + TP_ONE, force, s->bits);
  arb_mul(fy.of + TP_ONE, fy.of + TP_ONE, force, s->bits);
  tp_anchor_point(at[0].value, at[1].value, anchor, row);
  tp_load_point(x, y, &at[0], &at[1], s);
  tp_wrench_add_force(wrench, &fx, &fy, x, y, s->bits);
  fmpq_clear(number);
  fmpq_clear(at[0].value);
  fmpq_clear(at[1].value);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(x);
  arb_clear(y);
  arb_clear(force);
}
