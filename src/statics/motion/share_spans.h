/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Polynomials of a share of strength, in doubles, and the shares at which products of two are not
 * negative. */

#ifndef TP_MOTION_SHARE_SPANS_H
#define TP_MOTION_SHARE_SPANS_H

#include "number/near.h"
#include "topple.h"

/* Shares that are tried: beyond these, strength does not matter. */
#define TP_LEAST_SHARE 1e-6
#define TP_MOST_SHARE 1e6

enum { TP_SHARE_DEGREE = 3, TP_SHARE_CONDITIONS = 4 };

typedef struct tp_share_polynomial {
  double of[TP_SHARE_DEGREE + 1];
  int degree; /* -1 of none: zero, as far as its bounds tell */
} tp_share_polynomial;

/* Of coefficients from the constant on; what a bound does not tell from zero is none. */
tp_share_polynomial tp_share_polynomial_of(const tp_near coefficients[TP_SHARE_DEGREE + 1]);

/* Products of two that are not to be negative. */
typedef struct tp_share_conditions {
  int count;
  tp_share_polynomial of[TP_SHARE_CONDITIONS][2];
} tp_share_conditions;

/* The sign that it has at all shares from one to another; 0 where that is not seen at once. */
int tp_share_polynomial_sign(const tp_share_polynomial *p, double low, double high);

/* Between two shares. */
typedef struct tp_share_span {
  double low, high;
  tp_mechanism mechanism;
} tp_share_span;

typedef struct tp_share_spans {
  long count, room;
  tp_share_span *items;
} tp_share_spans;

/* Adds one, or those at which the conditions hold; false when memory is exhausted. */
TP_MUST_USE bool tp_share_spans_put(tp_share_spans *spans, tp_share_span span);
TP_MUST_USE bool tp_share_spans_where(tp_share_spans *spans, const tp_share_conditions *conditions,
                                      tp_mechanism mechanism);
void tp_share_spans_clear(tp_share_spans *spans);

/* Where what can begin with all of the strength, or cannot, first changes. */
typedef struct tp_share_change {
  bool found; /* false: nowhere within the shares that are tried */
  double share;
  tp_mechanism mechanism; /* of what begins or ends there */
} tp_share_change;

/* The change whose share is nearest to 1, as a ratio; sorts the spans. */
tp_share_change tp_share_spans_change(tp_share_spans *spans, bool can_begin);

#endif
