/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding by Patton's phi_b + i (Eq. 6), on the facet that governs as in the paper's Table 3.
 *
 * A facet wholly up-dip of the centroid sheds its load as soon as the table tilts (the paper's
 * section 4.5 on block F), so it does not count; of the others the block must climb the one that
 * rises most steeply down-dip, or where none rises it slides down the flattest: the largest signed
 * i. Where even level ground would be too steep for that, the block wedges itself between its
 * facets: the up-dip ones keep their load, and all count. This is a formula, not statics: the limit
 * analysis judges the contact forces. */

#include "stability/loaded.h"

#include "number/ball.h"

/* Integers that bracket the centroid's abscissa: a lattice abscissa x below `low` lies left of the
 * centroid, one above `high` right of it; equal on exact rungs but for the exact position. */
typedef struct foot {
  fmpz_t low, high;
  bool settled; /* a facet that ends within the bracket ends at the centroid, as far as can be told
                 */
} foot;

static void find_foot(const tp_evaluation *e, foot *f) {
  const long bits = tp_evaluation_bits(e);
  const arb_struct *sums = e->moments.weighted;
  f->settled = e->rung.level == TP_LEVEL_EXACT;
  if (f->settled) {
    fmpz_t divisor, moment;
    fmpz_init(divisor);
    fmpz_init(moment);
    arb_get_unique_fmpz(divisor, sums + TP_A2);
    arb_get_unique_fmpz(moment, sums + TP_X6);
    fmpz_mul_ui(divisor, divisor, 3);
    fmpz_cdiv_q(f->low, moment, divisor);
    fmpz_fdiv_q(f->high, moment, divisor);
    fmpz_clear(divisor);
    fmpz_clear(moment);
    return;
  }
  arb_t position;
  arf_t end;
  arb_init(position);
  arf_init(end);
  arb_div(position, sums + TP_X6, sums + TP_A2, bits);
  arb_div_ui(position, position, 3, bits);
  f->settled = tp_evaluation_is_zero_width(e, position, (double)e->problem->lattice.bits);
  if (arb_is_finite(position)) {
    arb_get_lbound_arf(end, position, bits);
    arf_get_fmpz(f->low, end, ARF_RND_CEIL);
    arb_get_ubound_arf(end, position, bits);
    arf_get_fmpz(f->high, end, ARF_RND_FLOOR);
  }
  arb_clear(position);
  arf_clear(end);
}

/* Does the facet reach down-dip of the centroid? */
static bool counts(tp_evaluation *e, const tp_facet *facet, const foot *f, tp_direction towards) {
  const tp_lattice *l = &e->problem->lattice;
  const fmpz *end = l->x + (towards == TP_TOWARDS_LEFT ? facet->q0 : facet->q1);
  const int to_low = fmpz_cmp(end, f->low), to_high = fmpz_cmp(end, f->high);
  const bool left = to_low<0, right = to_high> 0;
  if (!left && !right && !f->settled) e->certain = false;
  return towards == TP_TOWARDS_LEFT ? left : right;
}

/* Run and rise of the motion down-dip along a facet: (dx, rise) with i = atan2(rise, dx). */
static void motion(const tp_lattice *l, const tp_facet *f, tp_direction towards, fmpz_t run,
                   fmpz_t rise) {
  fmpz_sub(run, l->x + f->t1, l->x + f->t0);
  if (towards == TP_TOWARDS_LEFT) {
    fmpz_sub(rise, l->y + f->t0, l->y + f->t1);
  } else {
    fmpz_sub(rise, l->y + f->t1, l->y + f->t0);
  }
}

typedef struct governing_facet {
  long facet;   /* -1: none */
  bool blocked; /* a facet stands upright in the way */
  fmpz_t run, rise;
} governing_facet;

static void governing_init(governing_facet *best) {
  best->facet = -1;
  best->blocked = false;
  fmpz_init(best->run);
  fmpz_init(best->rise);
}

static void governing_clear(governing_facet *best) {
  fmpz_clear(best->run);
  fmpz_clear(best->rise);
}

/* Take the facet if its i is the largest so far; of two with the same i, one that has a length. */
static void consider(const tp_evaluation *e, long k, tp_direction towards, governing_facet *best) {
  const tp_facet *facets = e->problem->contact.facets, *facet = facets + k;
  if (facet->t0 == facet->t1) return; /* restrains nothing */
  fmpz_t run, rise, cross;
  fmpz_init(run);
  fmpz_init(rise);
  fmpz_init(cross);
  motion(&e->problem->lattice, facet, towards, run, rise);
  fmpz_mul(cross, rise, best->run);
  fmpz_submul(cross, best->rise, run);
  const int steeper = fmpz_sgn(cross);
  const bool longer = best->facet >= 0 && facet->q0 != facet->q1 &&
                      facets[best->facet].q0 == facets[best->facet].q1;
  if (fmpz_sgn(run) <= 0) { /* upright or turned away from the motion */
    if (fmpz_sgn(rise) > 0) best->blocked = true;
  } else if (best->facet < 0 || steeper > 0 || (steeper == 0 && longer)) {
    best->facet = k;
    fmpz_swap(best->run, run);
    fmpz_swap(best->rise, rise);
  }
  fmpz_clear(run);
  fmpz_clear(rise);
  fmpz_clear(cross);
}

/* The largest i among the facets that count, or among all. */
static void find_governing(tp_evaluation *e, tp_direction towards, const foot *f, bool all,
                           governing_facet *best) {
  const tp_contact *contact = &e->problem->contact;
  for (long k = 0; k < contact->facet_count; k++) {
    if (all || counts(e, contact->facets + k, f, towards)) consider(e, k, towards, best);
  }
}

/* phi_b + i. Where tan(phi_b) is rational, at 0 and 45 degrees, the direction is exact. */
static void add_friction(const tp_evaluation *e, const governing_facet *best,
                         tp_direction_ball *sliding) {
  const tp_quantity *friction = &e->problem->scene->friction_angle_deg;
  const long bits = e->rung.bits, exact = tp_evaluation_bits(e);
  fmpz_t sine, cosine;
  fmpz_init_set(sine, best->rise);
  fmpz_init_set(cosine, best->run);
  const bool zero = fmpq_is_zero(friction->value);
  sliding->exact_direction = zero || fmpq_cmp_si(friction->value, 45) == 0;
  if (sliding->exact_direction && !zero) { /* turned by 45 degrees */
    fmpz_add(sine, best->rise, best->run);
    fmpz_sub(cosine, best->run, best->rise);
  }
  arb_set_round_fmpz(sliding->sine, sine, exact);
  arb_set_round_fmpz(sliding->cosine, cosine, exact);
  tp_ball_atan2_degrees(sliding->degrees, sliding->sine, sliding->cosine, bits);
  if (!sliding->exact_direction) {
    arb_t angle;
    arb_init(angle);
    arb_set_fmpq(angle, friction->value, bits);
    arb_add(sliding->degrees, sliding->degrees, angle, bits);
    arb_clear(angle);
  }
  fmpz_clear(sine);
  fmpz_clear(cosine);
}

/* tan(phi_b + i) / tan(alpha). */
static tp_fos factor_of_safety(tp_evaluation *e, const tp_direction_ball *sliding, bool never) {
  const tp_quantity *tilt = &e->problem->scene->tilt_angle_deg;
  if (!tilt->given) return (tp_fos){.state = TP_FOS_NO_TILT};
  if (never || fmpq_is_zero(tilt->value)) return (tp_fos){.state = TP_FOS_NO_OVERTURNING};
  const long bits = e->rung.bits;
  tp_fos fos = {.state = TP_FOS_NUMBER};
  arb_t sine, cosine, value;
  arb_init(sine);
  arb_init(cosine);
  arb_init(value);
  tp_ball_sin_cos_degrees(sine, cosine, tilt->value, bits);
  if (sliding->exact_direction) {
    arb_div(value, sliding->sine, sliding->cosine, bits);
  } else {
    arb_div_ui(value, sliding->degrees, 180, bits);
    arb_tan_pi(value, value, bits);
  }
  arb_mul(value, value, cosine, bits);
  arb_div(value, value, sine, bits);
  fos.value = tp_evaluation_result(e, value);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(value);
  return fos;
}

/* tan(phi_b) / tan(alpha - i): the friction that is there over the friction that is needed. */
static tp_fos strength_factor(tp_evaluation *e, const arb_t facet_angle) {
  const tp_scene *scene = e->problem->scene;
  const long bits = e->rung.bits;
  if (!scene->tilt_angle_deg.given) return (tp_fos){.state = TP_FOS_NO_TILT};
  tp_fos fos = {.state = TP_FOS_NO_OVERTURNING};
  arb_t needed, value;
  arb_init(needed);
  arb_init(value);
  arb_set_fmpq(needed, scene->tilt_angle_deg.value, bits);
  arb_sub(needed, needed, facet_angle, bits);
  arb_set_ui(value, 90);
  if (arb_ge(needed, value)) {
    fos.state = TP_FOS_UNDEFINED; /* no friction would do */
  } else if (arb_is_positive(needed)) {
    fos.state = TP_FOS_NUMBER;
    arb_div_ui(needed, needed, 180, bits);
    arb_tan_pi(needed, needed, bits);
    arb_set_fmpq(value, scene->friction_angle_deg.value, bits);
    arb_div_ui(value, value, 180, bits);
    arb_tan_pi(value, value, bits);
    arb_div(value, value, needed, bits);
    fos.value = tp_evaluation_result(e, value);
  } else if (!arb_is_nonpositive(needed)) {
    e->certain = false;
  }
  arb_clear(needed);
  arb_clear(value);
  return fos;
}

static void describe(tp_evaluation *e, tp_case *result, const governing_facet *best,
                     tp_direction_ball *sliding) {
  tp_sliding *s = &result->sliding;
  const tp_facet *facet = e->problem->contact.facets + best->facet;
  arb_t rise, run, limit;
  arb_init(rise);
  arb_init(run);
  arb_init(limit);
  arb_set_fmpz(rise, best->rise);
  arb_set_fmpz(run, best->run);
  tp_ball_atan2_degrees(limit, rise, run, e->rung.bits);
  s->facet_angle_deg = tp_evaluation_result(e, limit);
  s->facet_x0_m = tp_evaluation_x(e->problem, facet->q0);
  s->facet_y0_m = tp_evaluation_y(e->problem, facet->q0);
  s->facet_x1_m = tp_evaluation_x(e->problem, facet->q1);
  s->facet_y1_m = tp_evaluation_y(e->problem, facet->q1);
  s->fos_strength = strength_factor(e, limit);
  if (e->loaded != NULL) {
    s->fos_strength = (tp_fos){.state = TP_FOS_NOT_ASKED};
    const bool slides =
        tp_loaded_sliding(sliding->degrees, &s->fos, e->loaded, e, best->run, best->rise);
    s->never = best->blocked || !slides;
    if (!s->never) s->critical_angle_deg = tp_evaluation_result(e, sliding->degrees);
    arb_clear(rise);
    arb_clear(run);
    arb_clear(limit);
    return;
  }
  add_friction(e, best, sliding);
  arb_set_ui(limit, 90);
  if (best->blocked || arb_ge(sliding->degrees, limit)) {
    s->never = true;
  } else if (!arb_lt(sliding->degrees, limit)) {
    e->certain = false;
  }
  s->critical_angle_deg = tp_evaluation_result(e, sliding->degrees);
  s->fos = factor_of_safety(e, sliding, s->never);
  arb_clear(rise);
  arb_clear(run);
  arb_clear(limit);
}

/* phi_b + i <= 0 */
static bool slides_when_level(tp_evaluation *e, const governing_facet *best) {
  tp_direction_ball limit;
  tp_direction_ball_init(&limit);
  add_friction(e, best, &limit);
  const bool slides = arb_is_nonpositive(limit.degrees) != 0;
  if (!slides && !arb_is_positive(limit.degrees)) e->certain = false;
  tp_direction_ball_clear(&limit);
  return slides;
}

void tp_evaluate_sliding(tp_evaluation *e, tp_case *result, tp_direction_ball *sliding) {
  result->sliding = (tp_sliding){0};
  if (!e->problem->scene->friction_angle_deg.given) return;
  foot f;
  governing_facet best;
  fmpz_init(f.low);
  fmpz_init(f.high);
  governing_init(&best);
  find_foot(e, &f);
  find_governing(e, result->towards, &f, false, &best);
  if (!best.blocked && (best.facet < 0 || slides_when_level(e, &best))) {
    find_governing(e, result->towards, &f, true, &best);
  }
  result->sliding.known = best.facet >= 0 || best.blocked;
  result->sliding.never = best.blocked;
  result->sliding.fos = (tp_fos){.state = TP_FOS_NO_OVERTURNING};
  if (best.facet >= 0) describe(e, result, &best, sliding);
  fmpz_clear(f.low);
  fmpz_clear(f.high);
  governing_clear(&best);
}

void tp_evaluate_toe(tp_evaluation *e, tp_case *result, const tp_direction_ball *toppling) {
  const tp_contact *contact = &e->problem->contact;
  result->toe = (tp_toe){0};
  if (!result->has_governing || e->loaded != NULL) return; /* the reaction is not the weight's */
  const long toe = contact->points[result->governing].point;
  governing_facet best;
  governing_init(&best);
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *facet = contact->facets + k;
    if (tp_facet_ends_in(&e->problem->lattice, facet, toe)) {
      consider(e, k, result->towards, &best);
    }
  }
  if (best.facet >= 0 || best.blocked) {
    tp_direction_ball limit;
    tp_direction_ball_init(&limit);
    result->toe.known = true;
    result->toe.upright = result->toe.holds = best.blocked;
    if (!best.blocked) {
      add_friction(e, &best, &limit);
      result->toe.limit_angle_deg = tp_evaluation_result(e, limit.degrees);
      result->toe.holds = tp_evaluation_compare(e, toppling, &limit) <= 0;
    }
    tp_direction_ball_clear(&limit);
  }
  governing_clear(&best);
}
