/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which facet governs sliding: by the inclination i of the motion down-dip along it; and i with its
 * friction. */

#include "evaluation/sliding_facet.h"

#include "evaluation/friction.h"
#include "number/ball.h"

/* Integers that bracket the centroid's abscissa: a lattice abscissa x below `low` lies left of the
 * centroid, one above `high` right of it; equal on exact rungs but for the exact position. */
typedef struct foot {
  fmpz_t low, high;
  arb_t position; /* where a facet ends in a tangent point */
  bool exact;     /* a facet that ends within the bracket ends at the centroid */
  bool settled;   /* and this, as far as the bits tell */
} foot;

static void find_foot(const tp_evaluation *e, foot *f) {
  const long bits = tp_evaluation_bits(e);
  const arb_struct *sums = e->moments.weighted;
  f->exact = e->rung.level == TP_LEVEL_EXACT;
  f->settled = false;
  arb_div(f->position, sums + TP_X6, sums + TP_A2, e->rung.bits);
  arb_div_ui(f->position, f->position, 3, e->rung.bits);
  if (f->exact) {
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
  arf_t end;
  arf_init(end);
  f->settled = tp_is_zero_width(e, f->position, (double)e->problem->lattice.bits);
  if (arb_is_finite(f->position)) {
    arb_get_lbound_arf(end, f->position, bits);
    arf_get_fmpz(f->low, end, ARF_RND_CEIL);
    arb_get_ubound_arf(end, f->position, bits);
    arf_get_fmpz(f->high, end, ARF_RND_FLOOR);
  }
  arf_clear(end);
}

/* Sign of the abscissa of a tangent point less the centroid's; 0 where it is not known. */
static int beside(const tp_evaluation *e, tp_outline_point at, const foot *f) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_point(x, y, e, at);
  const int side = arb_lt(x, f->position) ? -1 : arb_gt(x, f->position) ? 1 : 0;
  arb_clear(x);
  arb_clear(y);
  return side;
}

typedef enum reach { REACHES_NOT, REACHES, REACHES_PERHAPS } reach;

/* Does the facet reach down-dip of the centroid? One that ends below it does not. */
static reach reach_of(const tp_evaluation *e, const tp_facet *facet, const foot *f,
                      tp_direction towards) {
  const tp_lattice *l = &e->problem->lattice;
  const bool overhangs = fmpz_cmp(l->x + facet->t0, l->x + facet->t1) > 0;
  const bool begins = (towards == TP_TOWARDS_LEFT) != overhangs; /* its end down-dip */
  const tp_outline_point end = begins ? tp_facet_begin(facet) : tp_facet_end(facet);
  bool left = fmpz_cmp(l->x + end.point, f->low) < 0;
  bool right = fmpz_cmp(l->x + end.point, f->high) > 0;
  if (end.cut != NULL) {
    const int side = beside(e, end, f);
    left = side < 0;
    right = side > 0;
  }
  if (towards == TP_TOWARDS_LEFT ? left : right) return REACHES;
  return left || right || f->exact ? REACHES_NOT : REACHES_PERHAPS;
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

void tp_sliding_facet_init(tp_sliding_facet *best) {
  best->facet = -1;
  best->blocked = best->uneven = false;
  fmpz_init(best->run);
  fmpz_init(best->rise);
}

void tp_sliding_facet_clear(tp_sliding_facet *best) {
  fmpz_clear(best->run);
  fmpz_clear(best->rise);
}

void tp_sliding_facet_consider(const tp_evaluation *e, long k, tp_direction towards,
                               tp_sliding_facet *best) {
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

/* Sign of one i less another. */
static int compare_slopes(const tp_sliding_facet *a, const tp_sliding_facet *b) {
  fmpz_t cross;
  fmpz_init(cross);
  fmpz_mul(cross, a->rise, b->run);
  fmpz_submul(cross, b->rise, a->run);
  const int sign = fmpz_sgn(cross);
  fmpz_clear(cross);
  return sign;
}

/* Sign of the friction of one facet less that of another. */
static int compare_frictions(const tp_evaluation *e, long facet, long other) {
  const fmpq *scene = e->problem->scene->friction_angle_deg.value;
  const fmpq *a = tp_friction_own(e->problem, facet), *b = tp_friction_own(e->problem, other);
  return fmpq_cmp(a != NULL ? a : scene, b != NULL ? b : scene);
}

/* Along which of all facets parallel to the one that governs does it slide: it leans on them as it
 * likes, so on that of the least friction; of several the first from the toe. */
static void take_smoothest(tp_sliding_facet *best, const tp_evaluation *e, tp_direction towards) {
  const tp_contact *contact = &e->problem->contact;
  const long steepest = best->facet;
  for (long step = 0; step < contact->facet_count && steepest >= 0; step++) {
    const long k = towards == TP_TOWARDS_LEFT ? step : contact->facet_count - 1 - step;
    tp_sliding_facet own;
    tp_sliding_facet_init(&own);
    tp_sliding_facet_consider(e, k, towards, &own);
    const bool parallel = own.facet >= 0 && compare_slopes(&own, best) == 0;
    const int order = parallel ? compare_frictions(e, k, best->facet) : 0;
    if (order < 0) best->facet = k;
    best->uneven = best->uneven || order != 0;
    tp_sliding_facet_clear(&own);
  }
}

/* Would a facet that may reach or not govern? One that may not is of no matter. */
static bool changes(const tp_sliding_facet *best, const tp_evaluation *e, const foot *f,
                    tp_direction towards) {
  const tp_contact *contact = &e->problem->contact;
  tp_sliding_facet other;
  tp_sliding_facet_init(&other);
  other.facet = best->facet;
  other.blocked = best->blocked;
  fmpz_set(other.run, best->run);
  fmpz_set(other.rise, best->rise);
  for (long k = 0; k < contact->facet_count; k++) {
    if (reach_of(e, contact->facets + k, f, towards) == REACHES_PERHAPS) {
      tp_sliding_facet_consider(e, k, towards, &other);
    }
  }
  const bool differs = other.facet != best->facet || other.blocked != best->blocked;
  tp_sliding_facet_clear(&other);
  return differs;
}

void tp_sliding_facet_find(tp_sliding_facet *best, const tp_evaluation *e, tp_direction towards,
                           bool all, tp_certainty *certainty) {
  const tp_contact *contact = &e->problem->contact;
  foot f;
  fmpz_init(f.low);
  fmpz_init(f.high);
  arb_init(f.position);
  if (!all) find_foot(e, &f);
  const bool left = towards == TP_TOWARDS_LEFT;
  bool open = false;
  for (long step = 0; step < contact->facet_count; step++) { /* from the toe */
    const long k = left ? step : contact->facet_count - 1 - step;
    const reach r = all ? REACHES : reach_of(e, contact->facets + k, &f, towards);
    if (r == REACHES) tp_sliding_facet_consider(e, k, towards, best);
    open = open || r == REACHES_PERHAPS;
  }
  if (open && changes(best, e, &f, towards)) {
    if (f.settled) {
      tp_certainty_take_zero(certainty, e);
    } else {
      certainty->open = true;
    }
  }
  if (e->problem->friction.count > 0) take_smoothest(best, e, towards);
  fmpz_clear(f.low);
  fmpz_clear(f.high);
  arb_clear(f.position);
}

bool tp_sliding_facet_opens(const tp_evaluation *e, const tp_sliding_facet *best,
                            tp_direction towards) {
  const tp_contact *contact = &e->problem->contact;
  const tp_lattice *l = &e->problem->lattice;
  bool opens = best->facet >= 0;
  fmpz_t dx, dy, apart;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_init(apart);
  for (long k = 0; k < contact->facet_count && opens; k++) {
    const tp_facet *f = contact->facets + k;
    fmpz_sub(dx, l->x + f->t1, l->x + f->t0);
    fmpz_sub(dy, l->y + f->t1, l->y + f->t0);
    /* v . n, v = (-run, rise) or (run, rise), n = (-dy, dx) into the block */
    fmpz_mul(apart, best->run, dy);
    if (towards == TP_TOWARDS_RIGHT) fmpz_neg(apart, apart);
    fmpz_addmul(apart, best->rise, dx);
    opens = fmpz_sgn(apart) >= 0;
  }
  fmpz_clear(dx);
  fmpz_clear(dy);
  fmpz_clear(apart);
  return opens;
}

void tp_sliding_add_friction(const tp_evaluation *e, const tp_sliding_facet *best,
                             const arb_t friction, tp_direction_ball *sliding) {
  const long bits = e->rung.bits, exact = tp_evaluation_bits(e);
  fmpz_t sine, cosine;
  fmpz_init_set(sine, best->rise);
  fmpz_init_set(cosine, best->run);
  const bool zero = arb_is_zero(friction) != 0;
  sliding->exact_direction = zero || arb_equal_si(friction, 45);
  if (sliding->exact_direction && !zero) { /* turned by 45 degrees */
    fmpz_add(sine, best->rise, best->run);
    fmpz_sub(cosine, best->run, best->rise);
  }
  arb_set_round_fmpz(sliding->sine, sine, exact);
  arb_set_round_fmpz(sliding->cosine, cosine, exact);
  tp_ball_atan2_degrees(sliding->degrees, sliding->sine, sliding->cosine, bits);
  arb_set(sliding->inclination, sliding->degrees);
  sliding->adds = sliding->exact_direction ? NULL : tp_friction_exact(e, best->facet);
  if (!sliding->exact_direction) arb_add(sliding->degrees, sliding->degrees, friction, bits);
  fmpz_clear(sine);
  fmpz_clear(cosine);
}

void tp_sliding_add_friction_at(const tp_evaluation *e, const tp_sliding_facet *best,
                                const arb_t tilt, tp_direction_ball *sliding) {
  arb_t friction;
  arb_init(friction);
  tp_friction_of_facet(friction, e, best->facet, tilt);
  tp_sliding_add_friction(e, best, friction, sliding);
  arb_clear(friction);
}
