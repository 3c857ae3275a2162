/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding along a facet under loads: the force along it against friction and cohesion.
 *
 * With s the direction of motion along the facet and n its normal, the block slides where
 * F . s > -(F . n) tan phi + c S, S the area of the contact. With the weight alone and no cohesion
 * that is Patton's phi + i (Eq. 6). */

#include "evaluation/loaded.h"

#include "evaluation/facet_frame.h"
#include "evaluation/friction.h"
#include "load/zeros.h"
#include "number/ball.h"

#include <math.h>

/* F . s + (F . n) tan phi less cohesion. Its factors on F_x and F_y are formed first: where phi and
 * the facet's inclination make 90 degrees (at 45 each: Niven) the one on F_x is zero, exactly, and
 * the weight alone never slides. */
static void set_excess(tp_trig *excess, const tp_wrench *sum, const tp_facet_frame *f, long bits) {
  arb_t along_x, along_y;
  arb_init(along_x);
  arb_init(along_y);
  arb_mul(along_x, f->friction, f->rise, bits);
  arb_sub(along_x, along_x, f->run, bits);
  arb_mul(along_y, f->friction, f->run, bits);
  arb_add(along_y, along_y, f->rise, bits);
  tp_trig_addmul(excess, &sum->x, along_x, bits);
  tp_trig_addmul(excess, &sum->y, along_y, bits);
  arb_sub(excess->of + TP_ONE, excess->of + TP_ONE, f->cohesion, bits);
  arb_clear(along_x);
  arb_clear(along_y);
}

/* Of the weight times the size of the frame: what is far narrower about zero drives nothing. */
static double log2_scale(const tp_loaded *loaded, const tp_facet_frame *f) {
  const double weight = tp_ball_log2_above(loaded->items[0].wrench.y.of + TP_COS);
  return weight + fmax(tp_ball_log2_above(f->run), tp_ball_log2_above(f->rise));
}

/* What resists over what drives, at the scene's tilt: the pull of a passive anchor that holds back
 * counts as resistance. */
static tp_fos factor(const tp_loaded *loaded, const tp_evaluation *e, const tp_facet_frame *f,
                     tp_certainty *certainty) {
  const tp_quantity *tilt = &e->problem->scene->tilt_angle_deg;
  const long bits = e->rung.bits;
  if (!tilt->given) return (tp_fos){.state = TP_FOS_NO_TILT};
  tp_trig along, normal;
  arb_t sine, cosine, value, driving, resisting;
  arb_init(sine);
  arb_init(cosine);
  arb_init(value);
  arb_init(driving);
  arb_init(resisting);
  tp_ball_sin_cos_degrees(sine, cosine, tilt->value, bits);
  arb_set(resisting, f->cohesion);
  for (long k = 0; k < loaded->count; k++) {
    tp_trig_init(&along);
    tp_trig_init(&normal);
    tp_facet_frame_resolve(&along, &normal, &loaded->items[k].wrench, f, bits);
    tp_trig_evaluate(value, &normal, sine, cosine, bits);
    arb_addmul(resisting, value, f->friction, bits);
    tp_trig_evaluate(value, &along, sine, cosine, bits);
    if (loaded->items[k].passive && arb_is_negative(value)) {
      arb_sub(resisting, resisting, value, bits);
    } else if (loaded->items[k].passive && arb_contains_zero(value)) { /* on either side */
      mag_t size;
      mag_init(size);
      arb_get_mag(size, value);
      arb_add_error_mag(resisting, size);
      arb_add_error_mag(driving, size);
      mag_clear(size);
    } else {
      arb_add(driving, driving, value, bits);
    }
    tp_trig_clear(&along);
    tp_trig_clear(&normal);
  }
  tp_fos fos = {.state = TP_FOS_NO_OVERTURNING};
  if (arb_is_positive(driving)) {
    fos.state = TP_FOS_NUMBER;
    arb_div(value, resisting, driving, bits);
    fos.value = tp_result(e, value, certainty);
  } else if (!arb_is_nonpositive(driving)) {
    if (tp_is_zero_width(e, driving, log2_scale(loaded, f))) {
      tp_certainty_take_zero(certainty, e);
    } else {
      tp_certainty_leave_open(certainty, e);
      fos.state = TP_FOS_UNDECIDED;
    }
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(value);
  arb_clear(driving);
  arb_clear(resisting);
  return fos;
}

bool tp_loaded_sliding(arb_t degrees, tp_fos *fos, const tp_loaded *loaded, const tp_evaluation *e,
                       const fmpz_t run, const fmpz_t rise, const arb_t friction,
                       tp_certainty *certainty) {
  const long bits = e->rung.bits;
  tp_facet_frame f;
  tp_trig excess;
  tp_roots roots;
  arb_t level, sine, cosine;
  tp_facet_frame_init(&f, e, run, rise, friction);
  tp_trig_init(&excess);
  tp_roots_init(&roots);
  arb_init(level);
  arb_init(sine);
  arb_init(cosine);
  set_excess(&excess, &loaded->sum, &f, bits);
  tp_roots_find(&roots, &excess, bits);
  arb_one(cosine);
  tp_trig_evaluate(level, &excess, sine, cosine, bits);
  bool always = false;
  const bool found = tp_roots_critical(degrees, &always, &roots, level);
  if (!found && always) arb_set_si(degrees, -180);
  if (!roots.certain) certainty->open = true;
  if (tp_friction_is_load_dependent(e)) {
    arb_t present;
    arb_init(present);
    arb_set_fmpq(present, e->problem->scene->tilt_angle_deg.value, bits);
    tp_friction_at(present, e, present);
    tp_friction_tangent(f.friction, present, bits);
    arb_clear(present);
  }
  *fos = factor(loaded, e, &f, certainty);
  tp_facet_frame_clear(&f);
  tp_trig_clear(&excess);
  tp_roots_clear(&roots);
  arb_clear(level);
  arb_clear(sine);
  arb_clear(cosine);
  return found || always;
}
