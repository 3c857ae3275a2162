/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A pressure p0 … p1 along a line of the outline, normal to it and into the block, which lies to
 * the left of the line: on a thickness d the force (p0 + p1) d / 2 (-dy, dx), at the share (p0 + 2
 * p1) / (3 (p0 + p1)) of the line. */

#include "load/setting.h"

/* The line in the frame: a mirror image has the block on its left when it runs the other way. */
static void set_line(arb_t x0, arb_t y0, arb_t dx, arb_t dy, const tp_line_load *load,
                     const tp_load_setting *s) {
  tp_load_point(x0, y0, &load->x0, &load->y0, s);
  tp_load_point(dx, dy, &load->x1, &load->y1, s);
  arb_sub(dx, dx, x0, s->bits);
  arb_sub(dy, dy, y0, s->bits);
}

void tp_load_pressure(tp_wrench *wrench, const tp_line_load *load, const tp_load_setting *s) {
  tp_trig fx, fy;
  arb_t x, y, dx, dy, force, share;
  fmpq_t sum, part;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(x);
  arb_init(y);
  arb_init(dx);
  arb_init(dy);
  arb_init(force);
  arb_init(share);
  fmpq_init(sum);
  fmpq_init(part);
  set_line(x, y, dx, dy, load, s);
  fmpq_add(sum, load->first_kpa.value, load->last_kpa.value);
  if (!fmpq_is_zero(sum)) {
    arb_set_fmpq(force, sum, s->bits);
    arb_mul_ui(force, force, TP_KILO / 2, s->bits);
    arb_mul(force, force, s->thickness, s->bits);
    if (s->mirrored) arb_neg(force, force);
    arb_mul(fx.of + TP_ONE, force, dy, s->bits);
    arb_neg(fx.of + TP_ONE, fx.of + TP_ONE);
    arb_mul(fy.of + TP_ONE, force, dx, s->bits);
    fmpq_add(part, sum, load->last_kpa.value);
    fmpq_div(part, part, sum);
    arb_set_fmpq(share, part, s->bits);
    arb_div_ui(share, share, 3, s->bits);
    arb_addmul(x, share, dx, s->bits);
    arb_addmul(y, share, dy, s->bits);
    tp_wrench_add_force(wrench, &fx, &fy, x, y, s->bits);
  }
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(x);
  arb_clear(y);
  arb_clear(dx);
  arb_clear(dy);
  arb_clear(force);
  arb_clear(share);
  fmpq_clear(sum);
  fmpq_clear(part);
}
