/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The design value of a parameter (a friction angle, the mean of one, a depth) for a wanted
 * probability: where ln(p / wanted) changes its sign, by Brent's method (number/root.h) over
 * estimates of p. Let these be drawn by the same numbers at every value, then p leaps but does not
 * scatter. The interval is from where one end of p's own is the probability wanted to where the
 * other end is. */

#ifndef TP_STATISTICS_DESIGN_VALUE_H
#define TP_STATISTICS_DESIGN_VALUE_H

#include "common/message.h"
#include "statistics/estimate.h"

/* The probability at a value; a status other than TP_OK ends the search. */
typedef tp_status (*tp_probability_at)(tp_estimate *probability, void *context, double value,
                                       tp_message *message);

typedef struct tp_design_search {
  tp_probability_at probability_at;
  void *context;
  double wanted;    /* within (0, 1) */
  double low, high; /* where the value is looked for */
  double width;     /* to which it is to be found, above 0 */
} tp_design_search;

/* An end of the interval that lies beyond the range is infinite. TP_NO_ANSWER where the probability
 * is on one side of that wanted at both ends of the range. */
tp_status tp_design_value(tp_estimate *design, const tp_design_search *search,
                          tp_message *message) TP_MUST_USE;

#endif
