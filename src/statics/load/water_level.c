/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Water below a level: force and moment of the lines that it presses on, constant on the block
 * (load/wetted.h), in balls. */

#include "load/setting.h"

static void add_constant(arb_t sum, const fmpq_t value, const tp_load_setting *s) {
  arb_t own;
  arb_init(own);
  arb_set_fmpq(own, value, s->bits);
  arb_mul_ui(own, own, TP_KILO, s->bits);
  arb_addmul(sum, own, s->thickness, s->bits);
  arb_clear(own);
}

void tp_load_wet_lines(tp_wrench *wrench, const tp_wet_lines *lines, const tp_load_setting *s) {
  fmpq_t fx, fy, moment;
  fmpq_init(fx);
  fmpq_init(fy);
  fmpq_init(moment);
  tp_wet_lines_sum(fx, fy, moment, lines, s->scene->metres_per_unit, s->mirrored);
  add_constant(wrench->x.of + TP_ONE, fx, s);
  add_constant(wrench->y.of + TP_ONE, fy, s);
  add_constant(wrench->moment.of + TP_ONE, moment, s);
  fmpq_clear(fx);
  fmpq_clear(fy);
  fmpq_clear(moment);
}
