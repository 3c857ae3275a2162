/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Water behind the block, on a face normal to the base at the up-dip end of the base joint, the
 * heel, and in that joint, open or closed.
 *
 * Filled to the height h along the face the head at the base is h cos a: a triangle of pressure, on
 * a thickness d the force g h^2 d cos a / 2 towards down-dip, h / 3 over the heel. Where the level
 * stays horizontal h is vertical: the wetted face is h / cos a long, the force g h^2 d / (2 cos a),
 * h / (3 cos a) over the heel. Uplift falls linearly from the head at the heel to nothing at the
 * toe, normal to the mean plane: g h L d / 2 (times cos a, or not), L / 3 from the heel.
 *
 * Of a block that goes up-dip the uplift acts alone (problem/world.h), in a frame that is level
 * as the block lies on a dip d: heel and toe have changed places, the mean plane rises towards -x
 * in the direction (-cos d, sin d), its normal is (sin d, cos d), and cos a is cos (d - a). */

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

/* Its force and where it acts, of half the head at the heel for a unit of length, g h d / 2. */
static void lift_up_dip(tp_trig *fx, tp_trig *fy, arb_t x, arb_t y, const arb_t head,
                        const tp_load_setting *s) {
  const bool level = s->scene->loads.water.stays_level;
  arb_t cosine, sine, length, force;
  arb_init(cosine);
  arb_init(sine);
  arb_init(length);
  arb_init(force);
  arb_set_fmpq(cosine, s->scene->base.beyond_cosine, s->bits);
  arb_set_fmpq(sine, s->scene->base.beyond_sine, s->bits);
  arb_abs(sine, sine);
  /* from the down-dip end to the up-dip one, along the mean plane */
  arb_sub(x, s->heel_x, s->toe_x, s->bits);
  arb_mul(length, x, cosine, s->bits);
  arb_sub(y, s->toe_y, s->heel_y, s->bits);
  arb_addmul(length, y, sine, s->bits);
  arb_mul(force, head, length, s->bits);
  arb_div_ui(length, length, 3, s->bits);
  arb_set(x, s->toe_x);
  arb_addmul(x, length, cosine, s->bits);
  arb_set(y, s->toe_y);
  arb_submul(y, length, sine, s->bits);
  arb_mul(fx->of + TP_ONE, force, sine, s->bits);
  arb_mul(fy->of + TP_ONE, force, cosine, s->bits);
  tp_trig *const both[2] = {fx, fy};
  for (int k = 0; k < 2 && !level; k++) {
    arb_mul(both[k]->of + TP_COS, both[k]->of + TP_ONE, cosine, s->bits);
    arb_mul(both[k]->of + TP_SIN, both[k]->of + TP_ONE, sine, s->bits);
    arb_zero(both[k]->of + TP_ONE);
  }
  arb_clear(cosine);
  arb_clear(sine);
  arb_clear(length);
  arb_clear(force);
}

static void add_uplift_up_dip(tp_wrench *wrench, const tp_load_setting *s) {
  tp_trig fx, fy;
  arb_t head, x, y;
  tp_trig_init(&fx);
  tp_trig_init(&fy);
  arb_init(head);
  arb_init(x);
  arb_init(y);
  half_head(head, x, s);
  lift_up_dip(&fx, &fy, x, y, head, s);
  tp_wrench_add_force(wrench, &fx, &fy, x, y, s->bits);
  tp_trig_clear(&fx);
  tp_trig_clear(&fy);
  arb_clear(head);
  arb_clear(x);
  arb_clear(y);
}

void tp_load_uplift(tp_wrench *wrench, const tp_load_setting *s) {
  if (s->scene->loads.water.lifts_alone) {
    add_uplift_up_dip(wrench, s);
    return;
  }
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
