/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pseudo-static earthquake: k_h W horizontally towards down-dip, k_v W up, at the centroid. The
 * horizontal is (-cos a, sin a) in the block's frame, the vertical (sin a, cos a). */

#include "load/setting.h"

void tp_load_seismic(tp_wrench *wrench, const tp_load_setting *s) {
  const tp_loads_description *d = &s->scene->loads;
  tp_trig fx, fy;
  arb_t force;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(force);
  arb_set_fmpq(force, d->horizontal.value, s->bits);
  arb_mul(force, force, s->weight, s->bits);
  arb_neg(fx.of + TP_COS, force);
  arb_set(fy.of + TP_SIN, force);
  arb_set_fmpq(force, d->vertical.value, s->bits);
  arb_mul(force, force, s->weight, s->bits);
  arb_set(fx.of + TP_SIN, force);
  arb_set(fy.of + TP_COS, force);
  tp_wrench_add_force(wrench, &fx, &fy, s->x, s->y, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(force);
}
