/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding by Patton's phi_b + i (Eq. 6), on the facet that governs as in the paper's Table 3.
 *
 * A facet wholly up-dip of the centroid sheds its load as soon as the table tilts (the paper's
 * section 4.5 on block F), so it does not count; of the others the block must climb the one that
 * rises most steeply down-dip, or where none rises it slides down the flattest: the largest signed
 * i. Where even level ground would be too steep for that, the block wedges itself between its
 * facets: the up-dip ones keep their load, and all count. Where facets have frictions of their own,
 * phi_b is the smallest of the facet that governs and of all others parallel to it, as if all the
 * weight lay there. This is a formula, not statics: the limit analysis judges the contact forces.
 */

#include "evaluation/friction.h"
#include "evaluation/sliding_facet.h"
#include "evaluation/stages.h"

#include "number/ball.h"

/* Is an angle below 90 degrees for certain, by doubles? */
static bool is_below_upright(const arb_t degrees) {
  const tp_near angle = tp_ball_near(degrees);
  return angle.value + angle.error < 89;
}

/* tan(phi_b + i) / tan(alpha). */
static tp_fos factor_of_safety(const tp_evaluation *e, const tp_sliding_facet *best, bool never,
                               const tp_direction_ball *sliding, tp_certainty *certainty) {
  const tp_quantity *tilt = &e->problem->scene->tilt_angle_deg;
  if (!tilt->given) return (tp_fos){.state = TP_FOS_NO_TILT};
  if (never || fmpq_is_zero(tilt->value)) return (tp_fos){.state = TP_FOS_NO_OVERTURNING};
  const long bits = e->rung.bits;
  tp_fos fos = {.state = TP_FOS_NUMBER};
  tp_direction_ball at_tilt;
  arb_t value;
  tp_direction_ball_init(&at_tilt);
  arb_init(value);
  arb_set_fmpq(value, tilt->value, bits);
  const bool depends = tp_friction_is_load_dependent(e);
  if (depends) tp_sliding_add_friction_at(e, best, value, &at_tilt);
  const tp_direction_ball *shear = depends ? &at_tilt : sliding;
  if (shear->exact_direction) {
    arb_div(value, shear->sine, shear->cosine, bits);
  } else {
    arb_div_ui(value, shear->degrees, 180, bits);
    arb_tan_pi(value, value, bits);
  }
  tp_direction_ball_clear(&at_tilt);
  arb_mul(value, value, e->tilt_cosine, bits);
  arb_div(value, value, e->tilt_sine, bits);
  fos.value = tp_result(e, value, certainty);
  arb_clear(value);
  return fos;
}

/* tan(phi_b) / tan(alpha - i): the friction that is there over the friction that is needed. */
static tp_fos strength_factor(const tp_evaluation *e, long facet, const arb_t facet_angle,
                              tp_certainty *certainty) {
  const tp_scene *scene = e->problem->scene;
  const long bits = e->rung.bits;
  if (!scene->tilt_angle_deg.given) return (tp_fos){.state = TP_FOS_NO_TILT};
  tp_fos fos = {.state = TP_FOS_NO_OVERTURNING};
  arb_t needed, value, tilt;
  arb_init(needed);
  arb_init(value);
  arb_init(tilt);
  arb_set_fmpq(needed, scene->tilt_angle_deg.value, bits);
  arb_sub(needed, needed, facet_angle, bits);
  arb_set_ui(value, 90);
  if (!is_below_upright(needed) && arb_ge(needed, value)) {
    fos.state = TP_FOS_UNDEFINED; /* no friction would do */
  } else if (arb_is_positive(needed)) {
    fos.state = TP_FOS_NUMBER;
    arb_div_ui(needed, needed, 180, bits);
    arb_tan_pi(needed, needed, bits);
    arb_set_fmpq(tilt, scene->tilt_angle_deg.value, bits);
    tp_friction_of_facet(tilt, e, facet, tilt);
    tp_friction_facet_tangent(value, e, facet, tilt);
    arb_div(value, value, needed, bits);
    fos.value = tp_result(e, value, certainty);
  } else if (!arb_is_nonpositive(needed)) {
    tp_certainty_leave_open(certainty, e);
    fos.state = TP_FOS_UNDECIDED;
  }
  arb_clear(needed);
  arb_clear(value);
  arb_clear(tilt);
  return fos;
}

/* The motion along a facet and the tilt at which it starts, for a friction angle
 * (tp_friction_limit). */
typedef struct start {
  const tp_evaluation *e;
  tp_certainty *certainty;
  const tp_sliding_facet *best;
  tp_direction_ball *sliding;
  tp_sliding *result;
  bool slides;
} start;

static bool start_of(arb_t tilt, void *context, const arb_t friction, bool estimate) {
  (void)estimate;
  start *s = context;
  if (s->e->loaded == NULL) {
    tp_sliding_add_friction(s->e, s->best, friction, s->sliding);
    s->slides = true;
  } else {
    s->slides = tp_loaded_sliding(s->sliding->degrees, &s->result->fos, s->result, s->e->loaded,
                                  s->e, s->best->run, s->best->rise, friction, s->certainty);
  }
  arb_set(tilt, s->sliding->degrees);
  return s->slides;
}

/* Where no interval of tilts is mapped into itself, step by step. */
static bool find_stepwise(arb_t friction, start *s) {
  arb_struct *degrees = s->sliding->degrees;
  const tp_loaded_start found =
      tp_loaded_sliding_start(degrees, s->e->loaded, s->e, s->best->run, s->best->rise);
  if (found == TP_START_OPEN) s->certainty->open = true;
  if (found == TP_START_ALWAYS) arb_set_si(degrees, -180);
  if (found == TP_START_AT_ANGLE) tp_friction_at(friction, s->e, degrees);
  return found == TP_START_AT_ANGLE || found == TP_START_ALWAYS;
}

/* The friction angle at which it starts, and the start. */
static bool find_start(arb_t friction, start *s) {
  arb_t tilt;
  arb_init(tilt);
  bool found = true;
  if (tp_friction_is_load_dependent(s->e)) {
    found = tp_friction_meet(friction, s->e, start_of, s, false);
    if (!found && s->e->loaded != NULL) {
      arb_clear(tilt);
      return find_stepwise(friction, s);
    }
    if (!found && s->slides) s->certainty->open = true;
  } else {
    tp_friction_of_facet(friction, s->e, s->best->facet, tilt);
  }
  found = found && start_of(tilt, s, friction, false);
  arb_clear(tilt);
  return found;
}

static void describe_facet(const tp_evaluation *e, tp_sliding *s, const tp_sliding_facet *best,
                           arb_t angle, tp_certainty *certainty) {
  const tp_facet *facet = e->problem->contact.facets + best->facet;
  arb_t rise, run;
  arb_init(rise);
  arb_init(run);
  arb_set_fmpz(rise, best->rise);
  arb_set_fmpz(run, best->run);
  tp_ball_atan2_degrees(angle, rise, run, e->rung.bits);
  s->facet_angle_deg = tp_result(e, angle, certainty);
  tp_result_point(&s->facet_x0_m, &s->facet_y0_m, e, tp_facet_begin(facet), certainty);
  tp_result_point(&s->facet_x1_m, &s->facet_y1_m, e, tp_facet_end(facet), certainty);
  arb_clear(rise);
  arb_clear(run);
}

static void describe(const tp_evaluation *e, tp_case *result, const tp_sliding_facet *best,
                     tp_direction_ball *sliding, tp_certainty *certainty) {
  tp_sliding *s = &result->sliding;
  start own = {e, certainty, best, sliding, s, false};
  arb_t angle, friction;
  arb_init(angle);
  arb_init(friction);
  describe_facet(e, s, best, angle, certainty);
  const bool slides = find_start(friction, &own);
  s->friction_angle_deg = tp_result_of(e, friction);
  if (e->loaded != NULL) {
    s->fos_strength = (tp_fos){.state = TP_FOS_NOT_ASKED};
    s->never = best->blocked || !slides;
    s->always = !s->never && arb_equal_si(sliding->degrees, -180);
    if (!s->never && !s->always) s->critical_angle_deg = tp_result(e, sliding->degrees, certainty);
  } else {
    s->fos_strength = strength_factor(e, best->facet, angle, certainty);
    const bool below = is_below_upright(sliding->degrees);
    arb_set_ui(angle, 90);
    s->never = best->blocked || !slides || (!below && arb_ge(sliding->degrees, angle));
    if (!s->never && !below && !arb_lt(sliding->degrees, angle)) certainty->open = true;
    s->critical_angle_deg = tp_result(e, sliding->degrees, certainty);
    s->fos = factor_of_safety(e, best, s->never, sliding, certainty);
  }
  arb_clear(angle);
  arb_clear(friction);
}

/* phi_b + i <= 0 */
static bool slides_when_level(const tp_evaluation *e, const tp_sliding_facet *best,
                              tp_certainty *certainty) {
  const fmpq *own = best->facet >= 0 ? tp_friction_own(e->problem, best->facet) : NULL;
  const bool rough = own != NULL ? fmpq_sgn(own) > 0 : arb_is_positive(e->friction_tangent) != 0;
  if (fmpz_sgn(best->rise) >= 0 && rough) return false;
  tp_direction_ball limit;
  arb_t level;
  tp_direction_ball_init(&limit);
  arb_init(level);
  tp_sliding_add_friction_at(e, best, level, &limit);
  arb_clear(level);
  const bool slides = arb_is_nonpositive(limit.degrees) != 0;
  if (!slides && !arb_is_positive(limit.degrees)) certainty->open = true;
  tp_direction_ball_clear(&limit);
  return slides;
}

void tp_evaluate_sliding(const tp_evaluation *e, tp_case *result, tp_direction_ball *sliding,
                         tp_certainty *certainty) {
  result->sliding = (tp_sliding){0};
  if (!e->problem->scene->friction_angle_deg.given) return;
  tp_sliding_facet best;
  tp_sliding_facet_init(&best);
  tp_sliding_facet_find(&best, e, result->towards, false, certainty);
  if (!best.blocked && (best.facet < 0 || slides_when_level(e, &best, certainty))) {
    tp_sliding_facet_find(&best, e, result->towards, true, certainty);
  }
  result->sliding.known = best.facet >= 0 || best.blocked;
  result->sliding.never = best.blocked;
  result->sliding.uneven = best.uneven;
  result->sliding.fos = result->sliding.fos_strength = (tp_fos){.state = TP_FOS_NO_OVERTURNING};
  result->sliding.opens = !best.blocked && tp_sliding_facet_opens(e, &best, result->towards);
  if (best.facet >= 0) describe(e, result, &best, sliding, certainty);
  tp_sliding_facet_clear(&best);
}
