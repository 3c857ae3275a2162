/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A surcharge q on a line of the outline: q times its length and the thickness, as a weight at its
 * middle. */

#include "load/setting.h"

void tp_load_surcharge(tp_wrench *wrench, const tp_line_load *load, const tp_load_setting *s) {
  tp_trig fx, fy;
  arb_t x0, y0, x1, y1, force, length;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(x0);
  arb_init(y0);
  arb_init(x1);
  arb_init(y1);
  arb_init(force);
  arb_init(length);
  tp_load_point(x0, y0, &load->x0, &load->y0, s);
  tp_load_point(x1, y1, &load->x1, &load->y1, s);
  arb_sub(force, x1, x0, s->bits);
  arb_sub(length, y1, y0, s->bits);
  arb_hypot(length, force, length, s->bits);
  arb_set_fmpq(force, load->first_kpa.value, s->bits);
  arb_mul_ui(force, force, TP_KILO, s->bits);
  arb_mul(force, force, length, s->bits);
  arb_mul(force, force, s->thickness, s->bits);
  arb_neg(fx.of + TP_SIN, force);
  arb_neg(fy.of + TP_COS, force);
  arb_add(x0, x0, x1, s->bits);
  arb_mul_2exp_si(x0, x0, -1);
  arb_add(y0, y0, y1, s->bits);
  arb_mul_2exp_si(y0, y0, -1);
  tp_wrench_add_force(wrench, &fx, &fy, x0, y0, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(x0);
  arb_clear(y0);
  arb_clear(x1);
  arb_clear(y1);
  arb_clear(force);
  arb_clear(length);
}
