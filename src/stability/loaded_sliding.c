/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding along a facet under loads: the force along it against friction and cohesion.
 *
 * With s the direction of motion along the facet and n its normal, the block slides where
 * F . s > -(F . n) tan phi + c S, S the area of the contact. With the weight alone and no cohesion
 * that is Patton's phi + i (Eq. 6). */

#include "stability/loaded.h"

#include "number/ball.h"
#include "stability/friction.h"

#include <math.h>

/* size s = (-run, rise) and size n = (rise, run), exact: forces count times `size`, cohesion too.
 */
typedef struct facet_frame {
  arb_t run, rise, friction, cohesion;
} facet_frame;

/* Cohesion times the length of the contact and the thickness, N. */
static void set_cohesion(arb_t force, const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  const long bits = e->rung.bits;
  fmpq_t factor;
  arb_t dx, dy;
  fmpq_init(factor);
  arb_init(dx);
  arb_init(dy);
  arb_zero(force);
  for (long k = 0; k < problem->contact.facet_count; k++) {
    tp_evaluation_facet(dx, dy, e, problem->contact.facets + k);
    arb_hypot(dx, dx, dy, bits);
    arb_add(force, force, dx, bits);
  }
  tp_problem_thickness(factor, problem);
  fmpq_mul(factor, factor, problem->lattice.step_m);
  fmpq_mul(factor, factor, problem->scene->loads.cohesion_kpa.value);
  fmpq_mul_ui(factor, factor, 1000);
  arb_mul_fmpz(force, force, fmpq_numref(factor), bits);
  arb_div_fmpz(force, force, fmpq_denref(factor), bits);
  fmpq_clear(factor);
  arb_clear(dx);
  arb_clear(dy);
}

static void frame_init(facet_frame *f, const tp_evaluation *e, const fmpz_t run, const fmpz_t rise,
                       const arb_t friction) {
  const long bits = e->rung.bits;
  arb_t size;
  arb_init(size);
  arb_init(f->run);
  arb_init(f->rise);
  arb_init(f->friction);
  arb_init(f->cohesion);
  arb_set_fmpz(f->run, run);
  arb_set_fmpz(f->rise, rise);
  arb_hypot(size, f->run, f->rise, bits);
  tp_friction_tangent(f->friction, friction, bits);
  if (e->problem->scene->loads.cohesion_kpa.given) set_cohesion(f->cohesion, e);
  arb_mul(f->cohesion, f->cohesion, size, bits);
  arb_clear(size);
}

static void frame_clear(facet_frame *f) {
  arb_clear(f->run);
  arb_clear(f->rise);
  arb_clear(f->friction);
  arb_clear(f->cohesion);
}

/* along += F . s, normal -= F . n */
static void resolve(tp_trig *along, tp_trig *normal, const tp_wrench *wrench, const facet_frame *f,
                    long bits) {
  tp_trig_submul(along, &wrench->x, f->run, bits);
  tp_trig_addmul(along, &wrench->y, f->rise, bits);
  tp_trig_submul(normal, &wrench->x, f->rise, bits);
  tp_trig_submul(normal, &wrench->y, f->run, bits);
}

/* F . s + (F . n) tan phi less cohesion. Its factors on F_x and F_y are formed first: where phi and
 * the facet's inclination make 90 degrees (at 45 each: Niven) the one on F_x is zero, exactly, and
 * the weight alone never slides. */
static void set_excess(tp_trig *excess, const tp_wrench *sum, const facet_frame *f, long bits) {
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
static double log2_scale(const tp_loaded *loaded, const facet_frame *f) {
  const double weight = tp_ball_log2_above(loaded->items[0].wrench.y.of + TP_COS);
  return weight + fmax(tp_ball_log2_above(f->run), tp_ball_log2_above(f->rise));
}

/* What resists over what drives, at the scene's tilt: the pull of a passive anchor that holds back
 * counts as resistance. */
static tp_fos factor(const tp_loaded *loaded, tp_evaluation *e, const facet_frame *f) {
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
    resolve(&along, &normal, &loaded->items[k].wrench, f, bits);
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
    fos.value = tp_evaluation_result(e, value);
  } else if (!arb_is_nonpositive(driving) &&
             !tp_evaluation_is_zero_width(e, driving, log2_scale(loaded, f))) {
    if (!tp_evaluation_is_last_rung(e)) e->certain = false;
    fos.state = TP_FOS_UNDECIDED;
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(value);
  arb_clear(driving);
  arb_clear(resisting);
  return fos;
}

bool tp_loaded_sliding(arb_t degrees, tp_fos *fos, const tp_loaded *loaded, tp_evaluation *e,
                       const fmpz_t run, const fmpz_t rise, const arb_t friction) {
  const long bits = e->rung.bits;
  facet_frame f;
  tp_trig excess;
  tp_roots roots;
  arb_t level, sine, cosine;
  frame_init(&f, e, run, rise, friction);
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
  if (!roots.certain) e->certain = false;
  arb_t present;
  arb_init(present);
  arb_set_fmpq(present, e->problem->scene->tilt_angle_deg.value, bits);
  tp_friction_at(present, e, present);
  tp_friction_tangent(f.friction, present, bits);
  arb_clear(present);
  *fos = factor(loaded, e, &f);
  frame_clear(&f);
  tp_trig_clear(&excess);
  tp_roots_clear(&roots);
  arb_clear(level);
  arb_clear(sine);
  arb_clear(cosine);
  return found || always;
}

/* The force along the facet over what resists it, at any of the tilts in a ball, with the friction
 * that their stress gives. */
static void excess_at(arb_t excess, const tp_loaded *loaded, const tp_evaluation *e, facet_frame *f,
                      const arb_t degrees) {
  const long bits = e->rung.bits;
  tp_trig along, normal;
  arb_t friction, sine, cosine;
  tp_trig_init(&along);
  tp_trig_init(&normal);
  arb_init(friction);
  arb_init(sine);
  arb_init(cosine);
  resolve(&along, &normal, &loaded->sum, f, bits);
  tp_ball_sin_cos(sine, cosine, degrees, bits);
  tp_friction_at(friction, e, degrees);
  tp_friction_tangent(f->friction, friction, bits);
  tp_trig_submul(&along, &normal, f->friction, bits);
  tp_trig_evaluate(excess, &along, sine, cosine, bits);
  arb_sub(excess, excess, f->cohesion, bits);
  tp_trig_clear(&along);
  tp_trig_clear(&normal);
  arb_clear(friction);
  arb_clear(sine);
  arb_clear(cosine);
}

static int sign_of(const arb_t ball) {
  return arb_is_positive(ball) ? 1 : arb_is_negative(ball) ? -1 : 0;
}

/* From level the stretch on which the excess keeps its sign is made longer, by steps as long as
 * they prove it, until they and the friction on them are known well enough: behind the last one it
 * changes. Upright it may touch zero: no change. */
tp_loaded_start tp_loaded_sliding_start(arb_t degrees, const tp_loaded *loaded,
                                        const tp_evaluation *e, const fmpz_t run,
                                        const fmpz_t rise) {
  enum { SPARE = 8, MOST_STEPS = 40000 };
  const long bits = e->rung.bits;
  const slong least = -(slong)(3.33 * (e->digits + SPARE));
  facet_frame f;
  arb_t at, excess;
  arf_t from, to, step, last;
  arb_init(at);
  arb_init(excess);
  arf_init(from);
  arf_init(to);
  arf_init(step);
  arf_init(last);
  frame_init(&f, e, run, rise, at);
  excess_at(excess, loaded, e, &f, at);
  const int own = sign_of(excess); /* below zero: it holds on level ground */
  arf_set_d(last, own > 0 ? -loaded->range_deg : loaded->range_deg);
  arf_set_si(step, own > 0 ? -1 : 1);
  tp_loaded_start found = TP_START_OPEN;
  for (int k = 0; k < MOST_STEPS && own != 0; k++) {
    arf_add(to, from, step, bits, ARF_RND_NEAR);
    if (arf_cmpabs(to, last) > 0) arf_set(to, last);
    if (own < 0) {
      arb_set_interval_arf(at, from, to, bits);
    } else {
      arb_set_interval_arf(at, to, from, bits);
    }
    excess_at(excess, loaded, e, &f, at);
    if (sign_of(excess) == own) {
      arf_set(from, to);
      arf_mul_2exp_si(step, step, 1);
      if (arf_equal(to, last)) {
        found = own < 0 ? TP_START_NEVER : TP_START_ALWAYS;
        break;
      }
    } else if (arf_cmpabs_2exp_si(step, least) > 0 ||
               (arf_cmpabs_2exp_si(step, -bits) > 0 &&
                mag_cmp_2exp_si(arb_radref(f.friction), least + SPARE) > 0)) {
      arf_mul_2exp_si(step, step, -1);
    } else {
      arb_set(degrees, at);
      arb_set_arf(at, to);
      excess_at(excess, loaded, e, &f, at);
      if (sign_of(excess) == -own) {
        found = TP_START_AT_ANGLE;
      } else if (arf_equal(to, last)) {
        found = own < 0 ? TP_START_NEVER : TP_START_ALWAYS;
      }
      break;
    }
  }
  frame_clear(&f);
  arb_clear(at);
  arb_clear(excess);
  arf_clear(from);
  arf_clear(to);
  arf_clear(step);
  arf_clear(last);
  return found;
}
