/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Length of the contact facets in balls or, for exact coordinates, in doubles with a derived bound;
 * nominal length along the mean plane, contact ratio, and weight over contact area (the stress of
 * Table 2). */

#include "evaluation/contact_length.h"

#include "number/ball.h"

#include <float.h>
#include <math.h>

/* In balls. */
void tp_contact_length_in_balls(arb_t length, const tp_evaluation *e) {
  arb_t dx, dy;
  arb_init(dx);
  arb_init(dy);
  arb_zero(length);
  for (long k = 0; k < e->problem->contact.facet_count; k++) {
    tp_evaluation_facet(dx, dy, e, e->problem->contact.facets + k);
    arb_hypot(dx, dx, dy, e->rung.bits);
    arb_add(length, length, dx, e->rung.bits);
  }
  arb_clear(dx);
  arb_clear(dy);
}

/* The same in double, for exact coordinates: differences (1 rounding each), squares, sum, root make
 * at most 3.1 unit roundoffs for each length; two levels of summation add at most 1024 + n / 1024
 * more to a sum of positive terms. */
static void length_double(arb_t length, const tp_evaluation *e) {
  const tp_lattice *l = &e->problem->lattice;
  const long count = e->problem->contact.facet_count;
  double total = 0;
  enum { PART = 1024, OF_LENGTH = 6 }; /* facets summed at once; 3.1 roundings, with room */
  for (long from = 0; from < count; from += PART) {
    double part = 0;
    for (long k = from; k < count && k < from + PART; k++) {
      const tp_facet *f = e->problem->contact.facets + k;
      const double dx = l->u[f->q1] - l->u[f->q0], dy = l->v[f->q1] - l->v[f->q0];
      part += sqrt(dx * dx + dy * dy);
    }
    total += part;
  }
  const long parts = count / PART;
  const double roundings = PART + OF_LENGTH + (double)parts;
  tp_ball_set_bounded(length, total, 1.01 * roundings * DBL_EPSILON / 2 * total);
}

void tp_contact_length(arb_t length, const tp_evaluation *e) {
  if (e->rung.level == TP_LEVEL_DOUBLE && tp_lattice_is_exact(&e->problem->lattice) &&
      e->problem->corners.count == 0) {
    length_double(length, e);
  } else {
    tp_contact_length_in_balls(length, e);
  }
}

/* What ends in points of the lattice exactly. */
static void nominal_length(arb_t length, const tp_evaluation *e, bool of_sole) {
  const tp_problem *problem = e->problem;
  fmpz_t sum, dx;
  arb_t cut, cut_dx, cut_dy;
  fmpz_init(sum);
  fmpz_init(dx);
  arb_init(cut);
  arb_init(cut_dx);
  arb_init(cut_dy);
  for (long k = 0; k < problem->contact.facet_count; k++) {
    const tp_facet *f = problem->contact.facets + k;
    if (of_sole && !tp_sole_has(&problem->sole, &problem->lattice, f)) continue;
    if (tp_facet_begin(f).cut != NULL || tp_facet_end(f).cut != NULL) {
      tp_evaluation_facet(cut_dx, cut_dy, e, f);
      arb_abs(cut_dx, cut_dx);
      arb_add(cut, cut, cut_dx, e->rung.bits);
      continue;
    }
    fmpz_sub(dx, problem->lattice.x + f->q1, problem->lattice.x + f->q0);
    fmpz_abs(dx, dx);
    fmpz_add(sum, sum, dx);
  }
  arb_set_fmpz(length, sum);
  if (problem->corners.count > 0) arb_add(length, length, cut, e->rung.bits);
  fmpz_clear(sum);
  fmpz_clear(dx);
  arb_clear(cut);
  arb_clear(cut_dx);
  arb_clear(cut_dy);
}

void tp_contact_nominal_length(arb_t length, const tp_evaluation *e) {
  nominal_length(length, e, false);
}

bool tp_contact_ratio(arb_t ratio, const tp_evaluation *e) {
  fmpz_t length;
  fmpz_init(length);
  tp_sole_length(length, &e->problem->sole, &e->problem->lattice);
  const bool has_sole = fmpz_sgn(length) > 0;
  if (has_sole) {
    nominal_length(ratio, e, true);
    arb_div_fmpz(ratio, ratio, length, e->rung.bits);
  }
  fmpz_clear(length);
  return has_sole;
}

void tp_weight_per_area(arb_t pascal, const tp_evaluation *e, const arb_t length_m) {
  const long bits = e->rung.bits;
  fmpq_t width;
  fmpq_init(width);
  tp_problem_thickness(width, e->problem);
  tp_evaluation_weight(pascal, e);
  arb_div(pascal, pascal, length_m, bits);
  arb_div_fmpz(pascal, pascal, fmpq_numref(width), bits);
  arb_mul_fmpz(pascal, pascal, fmpq_denref(width), bits);
  fmpq_clear(width);
}
