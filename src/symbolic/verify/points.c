/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The values given with the claim, points near and far in the domain, and points beside the
 * isolated zeros of polynomials in one symbol. */

#include "verify/points.h"

#include "derive/field_work.h"
#include "verify/angle_range.h"
#include "verify/evaluate.h"

#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>
#include <stdlib.h>
#include <string.h>

enum { SIDES = 6, BITS = 128 };

/* Polynomials whose zeros are looked for: isolating them takes milliseconds at most. */
enum { MOST_DEGREE = 20, MOST_TERMS = 500, MOST_COEFFICIENT_BITS = 4000 };

/* The polynomial in one symbol, the others at the claim's values; false where it takes more than
 * whole numbers can say. */
static bool along(fmpz_poly_t out, const fmpz_mpoly_t p, long symbol, const tp_question *q) {
  const tp_field *field = q->subject->field;
  const slong degree = fmpz_mpoly_degree_si(p, symbol, field->ring);
  if (degree < 1 || degree > MOST_DEGREE || p->length > MOST_TERMS) return false;
  for (long a = 0; a < q->subject->angle_count; a++) {
    const tp_angle *angle = q->subject->angles + a;
    if (fmpz_mpoly_degree_si(p, angle->sine, field->ring) > 0 ||
        fmpz_mpoly_degree_si(p, angle->cosine, field->ring) > 0) {
      return false;
    }
  }
  fmpz_mpoly_q_t coefficient;
  fmpq_t values[MOST_DEGREE + 1];
  fmpz_t common;
  fmpz_init_set_ui(common, 1);
  fmpz_mpoly_q_init(coefficient, field->ring);
  bool known = true;
  for (slong k = 0; k <= degree; k++) {
    const slong symbols[1] = {symbol};
    const ulong exponents[1] = {(ulong)k};
    fmpq_init(values[k]);
    fmpz_mpoly_get_coeff_vars_ui(fmpz_mpoly_q_numref(coefficient), p, symbols, exponents, 1,
                                 field->ring);
    known = known && tp_field_evaluate_at(values[k], coefficient, q->sample->values, field);
    fmpz_lcm(common, common, fmpq_denref(values[k]));
  }
  for (slong k = 0; k <= degree; k++) {
    fmpq_mul_fmpz(values[k], values[k], common);
    fmpz_poly_set_coeff_fmpz(out, k, fmpq_numref(values[k]));
    fmpq_clear(values[k]);
  }
  fmpz_clear(common);
  fmpz_mpoly_q_clear(coefficient, field->ring);
  return known && fmpz_poly_degree(out) > 0 &&
         labs(fmpz_poly_max_bits(out)) < MOST_COEFFICIENT_BITS;
}

static void add_zeros(tp_points *points, const fmpz_poly_t polynomial, long symbol) {
  fmpz_poly_t free_of_squares, derivative;
  fmpz_poly_init(free_of_squares);
  fmpz_poly_init(derivative);
  fmpz_poly_derivative(derivative, polynomial);
  fmpz_poly_gcd(derivative, derivative, polynomial);
  fmpz_poly_div(free_of_squares, polynomial, derivative);
  const slong degree = fmpz_poly_degree(free_of_squares);
  acb_ptr roots = _acb_vec_init(degree);
  arb_fmpz_poly_complex_roots(roots, free_of_squares, 0, BITS);
  for (slong k = 0; k < degree && points->zero_count < TP_MOST_ROOTS; k++) {
    if (!arb_is_zero(acb_imagref(roots + k))) continue;
    tp_zero *zero = points->zeros + points->zero_count++;
    zero->symbol = symbol;
    fmpq_init(zero->value);
    arf_get_fmpq(zero->value, arb_midref(acb_realref(roots + k)));
  }
  _acb_vec_clear(roots, degree);
  fmpz_poly_clear(free_of_squares);
  fmpz_poly_clear(derivative);
}

static void find_zeros(tp_points *points, const fmpz_mpoly_t p) {
  const tp_question *q = points->question;
  for (long k = 0; k < q->subject->field->symbol_count; k++) {
    fmpz_poly_t polynomial;
    fmpz_poly_init(polynomial);
    if (along(polynomial, p, k, q)) add_zeros(points, polynomial, k);
    fmpz_poly_clear(polynomial);
  }
}

/* The directions that a formula is about; each name is looked at once. */
static void find_directions(tp_points *points, bool *seen, const tp_formula *formula) {
  tp_subject *s = points->question->subject;
  for (long k = 0; k < formula->count; k++) {
    const tp_formula_node *node = formula->nodes + k;
    const tp_name *name = NULL;
    tp_message ignored;
    if (node->kind != TP_FORMULA_NAME || seen[node->name]) continue;
    seen[node->name] = true;
    if (tp_subject_name(&name, s, node->name, &ignored) != TP_OK) continue;
    if (name->kind == TP_NAME_DEFINITION) find_directions(points, seen, &name->definition);
    if (name->kind != TP_NAME_DIRECTION || points->direction_count == TP_MOST_DIRECTIONS) continue;
    points->directions[points->direction_count] = name;
    points->quadrants[points->direction_count++] =
        tp_direction_quadrant(name, points->question->sample, s);
  }
}

tp_status tp_points_init(tp_points *points, const tp_question *q, const tp_branches *branches) {
  memset(points, 0, sizeof *points);
  points->question = q;
  points->units = tp_evaluate_units(q->printed, q->subject, BITS) +
                  tp_evaluate_units(q->quantity, q->subject, BITS);
  bool *seen = calloc((size_t)q->subject->name_count, sizeof *seen);
  if (seen == NULL) return tp_fail_memory(q->message, "a claim");
  find_directions(points, seen, q->printed);
  find_directions(points, seen, q->quantity);
  free(seen);
  for (long k = 0; branches != NULL && k < branches->count; k++) {
    find_zeros(points, fmpz_mpoly_q_numref(branches->items[k].of));
    find_zeros(points, fmpz_mpoly_q_denref(branches->items[k].of));
  }
  return TP_OK;
}

void tp_points_clear(tp_points *points) {
  for (long k = 0; k < points->zero_count; k++) fmpq_clear(points->zeros[k].value);
}

/* A zero moved to one of its sides, by an eighth of it or by 2^-20 of it; from 0 by as much of 1.
 */
static void beside(fmpq_t value, const fmpq_t zero, unsigned side) {
  static const int shifts[SIDES / 2] = {1, 3, 20};
  fmpq_t step;
  fmpq_init(step);
  fmpq_set(step, zero);
  if (fmpq_is_zero(step)) fmpq_one(step);
  fmpq_div_2exp(step, step, (ulong)shifts[side / 2]);
  if (side % 2 == 0) {
    fmpq_add(value, zero, step);
  } else {
    fmpq_sub(value, zero, step);
  }
  fmpq_clear(step);
}

/* The k-th of all points; false where it is not within the domain. */
static bool set_point(tp_claim_sample *sample, const tp_points *points, unsigned k) {
  const tp_domain *domain = points->question->subject->domain;
  const unsigned scattered = TP_DOMAIN_NEAR + TP_POINTS_WIDE;
  if (k == 0) return true;
  if (k < scattered) return tp_domain_scatter(sample, domain, k);
  const tp_zero *zero = points->zeros + (k - scattered) / SIDES;
  beside(sample->values + zero->symbol, zero->value, (k - scattered) % SIDES);
  return tp_domain_holds(domain, sample);
}

static bool keeps_directions(const tp_points *points, const tp_claim_sample *sample) {
  bool kept = true;
  for (long k = 0; k < points->direction_count && kept; k++) {
    kept = tp_direction_quadrant(points->directions[k], sample, points->question->subject) ==
           points->quadrants[k];
  }
  return kept;
}

bool tp_points_next(tp_claim_sample *sample, tp_points *points) {
  const tp_question *q = points->question;
  const unsigned all = TP_DOMAIN_NEAR + TP_POINTS_WIDE + SIDES * (unsigned)points->zero_count;
  while (points->at < all && tp_field_spend(q->subject->field, points->units)) {
    const unsigned k = points->at++;
    if (!tp_sample_init_copy(sample, q->sample)) {
      points->failed = true;
      return false;
    }
    if (set_point(sample, points, k) && (k == 0 || keeps_directions(points, sample))) return true;
    tp_sample_clear(sample);
  }
  return false;
}
