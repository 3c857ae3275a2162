/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The weight of the block: W (-sin a, -cos a) at its centroid. */

#include "load/setting.h"

void tp_load_weight(tp_wrench *wrench, const tp_load_setting *s) {
  tp_trig fx, fy;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_neg(fx.of + TP_SIN, s->weight);
  arb_neg(fy.of + TP_COS, s->weight);
  tp_wrench_add_force(wrench, &fx, &fy, s->x, s->y, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
}
