/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Water behind the block, on a face normal to the base at the up-dip end of the base joint, the
 * heel, and in that joint, open or closed.
 *
 * Filled to the height h along the face the head at the base is h cos a: a triangle of pressure, on
 * a thickness d the force g h^2 d cos a / 2 towards down-dip, h / 3 over the heel. Where the level
 * stays horizontal h is vertical: the wetted face is h / cos a long, the force g h^2 d / (2 cos a),
 * h / (3 cos a) over the heel. Uplift falls linearly from the head at the heel to nothing at the
 * toe, normal to the mean plane: g h L d / 2 (times cos a, or not), L / 3 from the heel. */

#include "load/setting.h"

/* g h d / 2 in N/m. */
static void half_head(arb_t value, arb_t height, const tp_load_setting *s) {
  const tp_water_description *water = &s->scene->loads.water;
  arb_set_fmpq(value, water->unit_weight_kn_m3.value, s->bits);
  arb_mul_ui(value, value, TP_KILO / 2, s->bits);
  tp_load_metres(height, water->height.value, s);
  arb_mul(value, value, height, s->bits);
  arb_mul(value, value, s->thickness, s->bits);
}

void tp_load_water(tp_wrench *wrench, const tp_load_setting *s) {
  const bool level = s->scene->loads.water.stays_level;
  tp_trig fx, fy;
  arb_t force, height;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(force);
  arb_init(height);
  half_head(force, height, s);
  arb_mul(force, force, height, s->bits);
  arb_neg(fx.of + (level ? TP_SEC : TP_COS), force);
  tp_wrench_add_force(wrench, &fx, &fy, s->heel_x, s->heel_y, s->bits);
  /* its moment about the heel: the force times its height over it, overturning */
  arb_mul(force, force, height, s->bits);
  arb_div_ui(force, force, 3, s->bits);
  arb_struct *own = wrench->moment.of + (level ? TP_SEC2 : TP_COS);
  arb_add(own, own, force, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(force);
  arb_clear(height);
}

void tp_load_uplift(tp_wrench *wrench, const tp_load_setting *s) {
  const bool level = s->scene->loads.water.stays_level;
  tp_trig fx, fy;
  arb_t force, length, x;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(force);
  arb_init(length);
  arb_init(x);
  half_head(force, x, s);
  arb_sub(length, s->heel_x, s->toe_x, s->bits);
  arb_mul(fy.of + (level ? TP_ONE : TP_COS), force, length, s->bits);
  arb_div_ui(x, length, 3, s->bits);
  arb_sub(x, s->heel_x, x, s->bits);
  tp_wrench_add_force(wrench, &fx, &fy, x, s->heel_y, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(force);
  arb_clear(length);
  arb_clear(x);
}
