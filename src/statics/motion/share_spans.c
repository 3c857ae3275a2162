/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Real zeros of polynomials of degree three at most in doubles (linear, quadratic, cubic by
 * bisection between its turning points), and the union of the intervals on which the conditions of
 * a mode hold. */

#include "motion/share_spans.h"

#include "common/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ZEROS = 2 * TP_SHARE_CONDITIONS * TP_SHARE_DEGREE };

/* ---- polynomials -------------------------------------------------------------------------------
 */

tp_share_polynomial tp_share_polynomial_of(const tp_near coefficients[TP_SHARE_DEGREE + 1]) {
  tp_share_polynomial p = {.degree = -1};
  for (int k = 0; k <= TP_SHARE_DEGREE; k++) {
    p.of[k] = tp_near_sign(coefficients[k]) != 0 ? coefficients[k].value : 0;
    if (p.of[k] != 0) p.degree = k;
  }
  return p;
}

static double evaluate(const tp_share_polynomial *p, double s) {
  double value = 0;
  for (int k = p->degree; k >= 0; k--) value = value * s + p->of[k];
  return value;
}

/* Sign, but for what rounding may have made of a zero. */
static int sign_at(const tp_share_polynomial *p, double s) {
  static const double share = 64 * DBL_EPSILON;
  double size = 0;
  for (int k = p->degree; k >= 0; k--) size = size * s + fabs(p->of[k]);
  const double value = evaluate(p, s);
  return fabs(value) <= share * size ? 0 : value > 0 ? 1 : -1;
}

/* The sign that it has throughout by that of all of its coefficients as a sum of Bernstein's
 * polynomials; 0 where they differ. */
int tp_share_polynomial_sign(const tp_share_polynomial *p, double low, double high) {
  const double w = high - low, *a = p->of;
  const double c0 = a[0] + low * (a[1] + low * (a[2] + low * a[3]));
  const double c1 = w * (a[1] + low * (2 * a[2] + low * 3 * a[3]));
  const double c2 = w * w * (a[2] + low * 3 * a[3]), c3 = w * w * w * a[3];
  const double b1 = c0 + c1 / 3, b2 = b1 + (c1 + c2) / 3, b3 = c0 + c1 + c2 + c3;
  if (c0 > 0 && b1 > 0 && b2 > 0 && b3 > 0) return 1;
  return c0 < 0 && b1 < 0 && b2 < 0 && b3 < 0 ? -1 : 0;
}

typedef struct zeros {
  int count;
  double of[MOST_ZEROS + 2];
} zeros;

static void put(zeros *z, double s) {
  if (s > TP_LEAST_SHARE && s < TP_MOST_SHARE) z->of[z->count++] = s;
}

/* Of degree 2 at most, the larger first by size, so that nothing cancels. */
static void put_quadratic(zeros *z, const tp_share_polynomial *p) {
  if (p->degree == 1) put(z, -p->of[0] / p->of[1]);
  if (p->degree != 2) return;
  const double half = p->of[1] / 2, rest = half * half - p->of[0] * p->of[2];
  if (rest < 0) {
    /* a double zero that rounding has parted */
    if (-rest <= 8 * DBL_EPSILON * half * half) put(z, -half / p->of[2]);
    return;
  }
  const double sum = -(half + copysign(sqrt(rest), half));
  put(z, sum / p->of[2]);
  if (sum != 0) put(z, p->of[0] / sum);
}

/* The zero between two shares on which the signs differ. */
static void put_between(zeros *z, const tp_share_polynomial *p, double low, double high) {
  enum { MOST_STEPS = 120 };
  const bool rising = evaluate(p, high) > 0;
  for (int k = 0; k < MOST_STEPS; k++) {
    const double middle = high > 4 * low ? sqrt(low * high) : low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    if ((evaluate(p, middle) > 0) == rising) {
      high = middle;
    } else {
      low = middle;
    }
  }
  put(z, low);
}

static int by_size(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return a < b ? -1 : a > b;
}

/* Of the third degree: between where it turns, it rises or falls throughout. */
static void put_cubic(zeros *z, const tp_share_polynomial *p) {
  const tp_share_polynomial slope = {{p->of[1], 2 * p->of[2], 3 * p->of[3]}, 2};
  zeros turns = {.count = 0};
  put(&turns, TP_LEAST_SHARE * (1 + DBL_EPSILON));
  put_quadratic(&turns, &slope);
  put(&turns, TP_MOST_SHARE * (1 - DBL_EPSILON));
  qsort(turns.of, (size_t)turns.count, sizeof turns.of[0], by_size);
  for (int k = 0; k < turns.count; k++) {
    if (sign_at(p, turns.of[k]) == 0) put(z, turns.of[k]);
    if (k == 0) continue;
    const double low = turns.of[k - 1], high = turns.of[k];
    if ((evaluate(p, low) > 0) != (evaluate(p, high) > 0)) put_between(z, p, low, high);
  }
}

static void put_zeros(zeros *z, const tp_share_polynomial *p) {
  if (p->degree == TP_SHARE_DEGREE) {
    put_cubic(z, p);
  } else {
    put_quadratic(z, p);
  }
}

/* ---- conditions --------------------------------------------------------------------------------
 */

static bool hold(const tp_share_conditions *c, double s) {
  for (int k = 0; k < c->count; k++) {
    if (sign_at(c->of[k], s) * sign_at(c->of[k] + 1, s) < 0) return false;
  }
  return true;
}

static bool is_same(const tp_share_polynomial *p, const tp_share_polynomial *q) {
  bool same = p->degree == q->degree;
  for (int k = 0; k <= TP_SHARE_DEGREE && same; k++) same = p->of[k] == q->of[k];
  return same;
}

bool tp_share_spans_where(tp_share_spans *spans, const tp_share_conditions *c,
                          tp_mechanism mechanism) {
  zeros z = {.count = 0};
  for (int k = 0; k < c->count; k++) {
    put_zeros(&z, c->of[k]);
    if (k == 0 || !is_same(c->of[k] + 1, c->of[k - 1] + 1)) {
      put_zeros(&z, c->of[k] + 1);
    }
  }
  qsort(z.of, (size_t)z.count, sizeof z.of[0], by_size);
  tp_share_span own = {.low = TP_LEAST_SHARE, .high = 0, .mechanism = mechanism};
  bool open = false;
  for (int k = 0; k <= z.count; k++) {
    const double low = k == 0 ? TP_LEAST_SHARE : z.of[k - 1];
    const double high = k == z.count ? TP_MOST_SHARE : z.of[k];
    const bool within = high > low && hold(c, sqrt(low) * sqrt(high));
    if (within && !open) own.low = low;
    if (within) own.high = high;
    if (open && !within && high > low) {
      if (!tp_share_spans_put(spans, own)) return false;
      open = false;
    }
    open = open || within;
  }
  return !open || tp_share_spans_put(spans, own);
}

/* What rounding may have parted, or put between. */
static const double joint = 1e-12;

bool tp_share_spans_put(tp_share_spans *spans, tp_share_span span) {
  if (span.high <= span.low * (1 + joint)) return true; /* at a single share at most */
  tp_share_span *more = tp_grow(spans->items, spans->count, &spans->room, sizeof *more);
  if (more == NULL) return false;
  spans->items = more;
  more[spans->count++] = span;
  return true;
}

void tp_share_spans_clear(tp_share_spans *spans) {
  free(spans->items);
  memset(spans, 0, sizeof *spans);
}

/* ---- the nearest change ------------------------------------------------------------------------
 */

static int by_low(const void *left, const void *right) {
  const tp_share_span *a = left, *b = right;
  return a->low < b->low ? -1 : a->low > b->low;
}

static void nearer(tp_share_change *change, double share, tp_mechanism mechanism) {
  if (share <= TP_LEAST_SHARE * (1 + joint) || share >= TP_MOST_SHARE * (1 - joint)) return;
  if (change->found && fabs(log(share)) >= fabs(log(change->share))) return;
  *change = (tp_share_change){true, share, mechanism};
}

tp_share_change tp_share_spans_change(tp_share_spans *spans, bool can_begin) {
  tp_share_change change = {.found = false};
  if (spans->count > 0) qsort(spans->items, (size_t)spans->count, sizeof *spans->items, by_low);
  if (!can_begin) {
    for (long k = 0; k < spans->count; k++) {
      const tp_share_span *own = spans->items + k;
      if (own->low > 1) nearer(&change, own->low, own->mechanism);
      if (own->high < 1) nearer(&change, own->high, own->mechanism);
      if (own->low <= 1 && own->high >= 1) nearer(&change, 1, own->mechanism);
    }
    return change;
  }
  /* spans that meet, put together: those that hold 1 end at the changes */
  tp_share_span sum = {.low = 1, .high = 1};
  bool any = false;
  for (long k = 0; k < spans->count; k++) {
    const tp_share_span *own = spans->items + k;
    if (any && own->low <= sum.high * (1 + joint)) {
      if (own->high > sum.high) {
        sum.high = own->high;
        sum.mechanism = own->mechanism;
      }
      continue;
    }
    if (any && sum.high >= 1) break;
    sum = *own;
    any = true;
  }
  const bool holds = any && sum.low <= 1 + joint && sum.high >= 1 - joint;
  nearer(&change, holds ? sum.low : 1, sum.mechanism);
  nearer(&change, holds ? sum.high : 1, sum.mechanism);
  return change;
}
