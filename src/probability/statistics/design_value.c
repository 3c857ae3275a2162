/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Brent's method on ln(p / wanted) for the estimate and for both ends of its interval. */

#include "statistics/design_value.h"

#include "number/root.h"

#include <math.h>

/* Which of an estimate's three numbers is to be the probability wanted. */
typedef enum part { VALUE, LOW, HIGH } part;

typedef struct crossing {
  const tp_design_search *search;
  part part;
  tp_status status;
  tp_message *message;
} crossing;

/* ln(p / wanted); a probability of 0 counts as the least double, so that all are finite. */
static double excess_of(const tp_estimate *e, part which, double wanted) {
  const double p = which == VALUE ? e->value : which == LOW ? e->low : e->high;
  return log(fmax(p, 0x1p-1022)) - log(wanted);
}

static bool excess(double *value, void *context, double x) {
  crossing *c = context;
  tp_estimate e;
  c->status = c->search->probability_at(&e, c->search->context, x, c->message);
  if (c->status == TP_OK) *value = excess_of(&e, c->part, c->search->wanted);
  return c->status == TP_OK;
}

/* Where one of the three crosses; the estimates at the ends are at hand. */
static tp_status cross(double *at, bool *crosses, const tp_design_search *s, part which,
                       const tp_estimate ends[2], tp_message *message) {
  enum { MOST = 200 };
  static const double flat = 1e-12;
  crossing c = {s, which, TP_OK, message};
  const tp_root_end low = {s->low, excess_of(ends, which, s->wanted)};
  const tp_root_end high = {s->high, excess_of(ends + 1, which, s->wanted)};
  const tp_root_search search = {excess, &c, flat, s->width, MOST};
  tp_root root;
  *crosses = (low.value < 0) != (high.value < 0);
  if (!*crosses) return TP_OK;
  if (!tp_root_find(&root, &search, low, high)) {
    if (c.status != TP_OK) return c.status;
    return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                   "the probability is not a number somewhere from %g to %g", s->low, s->high);
  }
  *at = root.low + (root.high - root.low) / 2;
  return TP_OK;
}

/* p's lower end crosses before its value does where p falls, and after it where p rises; where an
 * end does not cross within the range, it does beyond it, on that side, if anywhere. */
static tp_status ends_of(tp_estimate *design, const tp_design_search *s, const tp_estimate ends[2],
                         tp_message *message) {
  double at[2] = {INFINITY, INFINITY};
  for (int k = 0; k < 2; k++) {
    bool crosses;
    const tp_status status = cross(at + k, &crosses, s, k == 0 ? LOW : HIGH, ends, message);
    if (status != TP_OK) return status;
    if (crosses) continue;
    const bool falls = ends[1].value < ends[0].value;
    at[k] = falls == (k == 0) ? -INFINITY : INFINITY;
  }
  design->low = fmin(fmin(at[0], at[1]), design->value);
  design->high = fmax(fmax(at[0], at[1]), design->value);
  return TP_OK;
}

tp_status tp_design_value(tp_estimate *design, const tp_design_search *search,
                          tp_message *message) {
  const tp_design_search *s = search;
  tp_estimate ends[2], own;
  bool crosses;
  if (!(s->wanted > 0 && s->wanted < 1) || !(s->low < s->high) || !(s->width > 0)) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "a design value for a probability of %g from %g to %g, to %g: give a "
                     "probability within (0, 1), a range, and a width above 0",
                     s->wanted, s->low, s->high, s->width);
  }
  tp_status status = s->probability_at(ends, s->context, s->low, message);
  if (status == TP_OK) status = s->probability_at(ends + 1, s->context, s->high, message);
  if (status == TP_OK) status = cross(&own.value, &crosses, s, VALUE, ends, message);
  if (status != TP_OK) return status;
  if (!crosses) {
    return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                   "the probability is %g at %g and %g at %g, and that wanted, %g, not between "
                   "them: look in another range",
                   ends[0].value, s->low, ends[1].value, s->high, s->wanted);
  }
  status = ends_of(&own, s, ends, message);
  if (status == TP_OK) *design = own;
  return status;
}
