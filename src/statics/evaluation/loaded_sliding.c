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

/* Sums over the loads at the scene's tilt, times the size of the frame. */
typedef struct sums {
  arb_t normal, uplift, held, driving, resisting;
} sums;

static void sums_init(sums *own) {
  arb_init(own->normal);
  arb_init(own->uplift);
  arb_init(own->held);
  arb_init(own->driving);
  arb_init(own->resisting);
}

static void sums_clear(sums *own) {
  arb_clear(own->normal);
  arb_clear(own->uplift);
  arb_clear(own->held);
  arb_clear(own->driving);
  arb_clear(own->resisting);
}

/* What a load does along the facet: the pull of a passive anchor that holds back counts as
 * resistance, and one whose sign is not known on either side. */
static void add_along(sums *own, const arb_t value, bool passive, long bits) {
  if (passive && arb_is_negative(value)) {
    arb_sub(own->held, own->held, value, bits);
  } else if (passive && arb_contains_zero(value)) {
    mag_t size;
    mag_init(size);
    arb_get_mag(size, value);
    arb_add_error_mag(own->held, size);
    arb_add_error_mag(own->driving, size);
    mag_clear(size);
  } else {
    arb_add(own->driving, own->driving, value, bits);
  }
}

static void add_loads(sums *own, const tp_loaded *loaded, const tp_evaluation *e,
                      const tp_facet_frame *f) {
  const long bits = e->rung.bits;
  tp_trig along, normal;
  arb_t sine, cosine, value;
  arb_init(sine);
  arb_init(cosine);
  arb_init(value);
  tp_ball_sin_cos_degrees(sine, cosine, e->problem->scene->tilt_angle_deg.value, bits);
  for (long k = 0; k < loaded->count; k++) {
    const tp_load *load = loaded->items + k;
    tp_trig_init(&along);
    tp_trig_init(&normal);
    tp_facet_frame_resolve(&along, &normal, &load->wrench, f, bits);
    tp_trig_evaluate(value, &normal, sine, cosine, bits);
    if (load->kind == TP_LOAD_WATER || load->kind == TP_LOAD_UPLIFT) {
      arb_sub(own->uplift, own->uplift, value, bits);
    } else {
      arb_add(own->normal, own->normal, value, bits);
    }
    tp_trig_evaluate(value, &along, sine, cosine, bits);
    add_along(own, value, load->passive, bits);
    tp_trig_clear(&along);
    tp_trig_clear(&normal);
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(value);
}

/* The forces themselves: the sums over the size of the frame. */
static void tell(tp_sliding *forces, const sums *own, const tp_evaluation *e,
                 const tp_facet_frame *f) {
  const long bits = e->rung.bits;
  arb_t size, value;
  arb_init(size);
  arb_init(value);
  arb_hypot(size, f->run, f->rise, bits);
  forces->has_forces = true;
  forces->friction_tangent = tp_result_of(e, f->friction);
  arb_div(value, own->normal, size, bits);
  forces->normal_n = tp_result_of(e, value);
  arb_div(value, own->uplift, size, bits);
  forces->uplift_n = tp_result_of(e, value);
  arb_div(value, f->cohesion, size, bits);
  forces->cohesion_n = tp_result_of(e, value);
  arb_div(value, own->held, size, bits);
  forces->held_n = tp_result_of(e, value);
  arb_div(value, own->driving, size, bits);
  forces->driving_n = tp_result_of(e, value);
  arb_clear(size);
  arb_clear(value);
}

/* What resists over what drives, at the scene's tilt. */
static tp_fos factor(tp_sliding *forces, const tp_loaded *loaded, const tp_evaluation *e,
                     const tp_facet_frame *f, tp_certainty *certainty) {
  const long bits = e->rung.bits;
  sums own;
  if (!e->problem->scene->tilt_angle_deg.given) return (tp_fos){.state = TP_FOS_NO_TILT};
  sums_init(&own);
  add_loads(&own, loaded, e, f);
  arb_sub(own.resisting, own.normal, own.uplift, bits);
  arb_mul(own.resisting, own.resisting, f->friction, bits);
  arb_add(own.resisting, own.resisting, f->cohesion, bits);
  arb_add(own.resisting, own.resisting, own.held, bits);
  if (forces != NULL) tell(forces, &own, e, f);
  tp_fos fos = {.state = TP_FOS_NO_OVERTURNING};
  if (arb_is_positive(own.driving)) {
    fos.state = TP_FOS_NUMBER;
    arb_div(own.resisting, own.resisting, own.driving, bits);
    fos.value = tp_result(e, own.resisting, certainty);
  } else if (!arb_is_nonpositive(own.driving)) {
    if (tp_is_zero_width(e, own.driving, log2_scale(loaded, f))) {
      tp_certainty_take_zero(certainty, e);
    } else {
      tp_certainty_leave_open(certainty, e);
      fos.state = TP_FOS_UNDECIDED;
    }
  }
  sums_clear(&own);
  return fos;
}

bool tp_loaded_sliding(arb_t degrees, tp_fos *fos, tp_sliding *forces, const tp_loaded *loaded,
                       const tp_evaluation *e, const fmpz_t run, const fmpz_t rise,
                       const arb_t friction, tp_certainty *certainty) {
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
  *fos = factor(forces, loaded, e, &f, certainty);
  tp_facet_frame_clear(&f);
  tp_trig_clear(&excess);
  tp_roots_clear(&roots);
  arb_clear(level);
  arb_clear(sine);
  arb_clear(cosine);
  return found || always;
}
