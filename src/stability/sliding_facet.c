/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which facet governs sliding: by the inclination i of the motion down-dip along it. */

#include "stability/sliding_facet.h"

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

void tp_sliding_facet_init(tp_sliding_facet *best) {
  best->facet = -1;
  best->blocked = false;
  fmpz_init(best->run);
  fmpz_init(best->rise);
}

void tp_sliding_facet_clear(tp_sliding_facet *best) {
  fmpz_clear(best->run);
  fmpz_clear(best->rise);
}

/* Take the facet if its i is the largest so far; of two with the same i, one that has a length. */
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

void tp_sliding_facet_find(tp_sliding_facet *best, tp_evaluation *e, tp_direction towards,
                           bool all) {
  const tp_contact *contact = &e->problem->contact;
  foot f;
  fmpz_init(f.low);
  fmpz_init(f.high);
  if (!all) find_foot(e, &f);
  for (long k = 0; k < contact->facet_count; k++) {
    if (all || counts(e, contact->facets + k, &f, towards)) {
      tp_sliding_facet_consider(e, k, towards, best);
    }
  }
  fmpz_clear(f.low);
  fmpz_clear(f.high);
}
