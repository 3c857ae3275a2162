/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ranges of angles over a domain: equal tangents say that two angles differ by a multiple of 180
 * degrees, and ranges that do not reach so far say that it is none. */

#include "verify/angle_range.h"

#include "number/ball.h"
#include "verify/domain.h"

#include <math.h>

typedef struct range {
  double low, high; /* open, unless it is a point */
  bool known;
} range;

static const range unknown = {0, 0, false};

int tp_direction_quadrant(const tp_name *name, const tp_claim_sample *sample, tp_subject *s) {
  arb_t rise, run;
  arb_init(rise);
  arb_init(run);
  tp_sample_evaluate(rise, name->value, sample, s, 128);
  tp_sample_evaluate(run, name->run, sample, s, 128);
  int quadrant = 0;
  if (arb_is_positive(rise)) quadrant = arb_is_positive(run) ? 1 : arb_is_negative(run) ? 2 : 0;
  if (arb_is_negative(rise)) quadrant = arb_is_positive(run) ? 4 : arb_is_negative(run) ? 3 : 0;
  arb_clear(rise);
  arb_clear(run);
  return quadrant;
}

/* What the ranges of a claim take; definitions may double. */
typedef struct search {
  const tp_question *q;
  long left; /* of the nodes that may be looked at */
} search;

/* Of a formula with all that its names stand for: beyond it a range is unknown. */
enum { MOST_NODES = 20000 };

static range of_formula(const tp_formula *formula, search *w);

static range of_angle(search *w, long angle) {
  double low = 0, high = 0;
  if (!tp_domain_angle(&low, &high, w->q->subject->domain, angle)) return unknown;
  return (range){low, high, true};
}

static range of_name(search *w, long index) {
  const tp_name *name = NULL;
  tp_message ignored;
  if (tp_subject_name(&name, w->q->subject, index, &ignored) != TP_OK) return unknown;
  if (name->kind == TP_NAME_ANGLE) return of_angle(w, name->angle);
  if (name->kind == TP_NAME_DEFINITION) return of_formula(&name->definition, w);
  if (name->kind != TP_NAME_DIRECTION) return unknown;
  switch (tp_direction_quadrant(name, w->q->sample, w->q->subject)) {
  case 1:
    return (range){0, 90, true};
  case 2:
    return (range){90, 180, true};
  case 3:
    return (range){-180, -90, true};
  case 4:
    return (range){-90, 0, true};
  default:
    return unknown;
  }
}

/* Numbers of few digits alone: their sums in doubles are then on the right side of 180. */
static range of_number(const fmpq *number) {
  enum { MOST_BITS = 30, MOST_BITS_BELOW = 10 };
  if (fmpz_bits(fmpq_numref(number)) > MOST_BITS ||
      fmpz_bits(fmpq_denref(number)) > MOST_BITS_BELOW) {
    return unknown;
  }
  const double value = fmpq_get_d(number);
  return (range){value, value, true};
}

static range scaled(range r, double factor) {
  if (!r.known || !isfinite(factor)) return unknown;
  const double low = r.low * factor, high = r.high * factor;
  return factor < 0 ? (range){high, low, true} : (range){low, high, true};
}

static range of_node(const tp_formula *f, long index, search *w) {
  if (--w->left < 0) return unknown;
  const tp_formula_node *n = f->nodes + index;
  const bool binary = n->right >= 0;
  const range left = n->left >= 0 && n->kind != TP_FORMULA_CALL ? of_node(f, n->left, w) : unknown;
  const range right = binary ? of_node(f, n->right, w) : unknown;
  switch (n->kind) {
  case TP_FORMULA_NUMBER:
    return of_number(&n->value);
  case TP_FORMULA_NAME:
    return of_name(w, n->name);
  case TP_FORMULA_NEGATE:
    return scaled(left, -1);
  case TP_FORMULA_ADD:
    return (range){left.low + right.low, left.high + right.high, left.known && right.known};
  case TP_FORMULA_SUBTRACT:
    return (range){left.low - right.high, left.high - right.low, left.known && right.known};
  case TP_FORMULA_MULTIPLY:
    if (left.known && left.low == left.high) return scaled(right, left.low);
    return right.low == right.high ? scaled(left, right.low) : unknown;
  case TP_FORMULA_DIVIDE:
    return right.known && right.low == right.high ? scaled(left, 1 / right.low) : unknown;
  case TP_FORMULA_CALL:
    return n->function == TP_FUNCTION_ATAN ? (range){-90, 90, true} : unknown;
  default:
    return unknown;
  }
}

static range of_formula(const tp_formula *formula, search *w) {
  return of_node(formula, formula->count - 1, w);
}

bool tp_angles_in_reach(const tp_question *q) {
  search w = {q, MOST_NODES};
  const range printed = of_formula(q->printed, &w), quantity = of_formula(q->quantity, &w);
  if (!printed.known || !quantity.known) return false;
  /* an open range does not reach its ends */
  const bool open = printed.low < printed.high || quantity.low < quantity.high;
  const double most = printed.high - quantity.low, least = printed.low - quantity.high;
  return open ? most <= 180 && least >= -180 : most < 180 && least > -180;
}
