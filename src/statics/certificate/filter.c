/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A twist in the scaled units of the linear program, in doubles, and the error bound of its powers
 * stated in the header. */

#include "certificate/filter.h"

#include "number/ball.h"
#include "number/binary.h"

#include <float.h>
#include <math.h>

/* |v . c - fl(v . c)| <= sum |v_k| e + (r_k + 4 u |v_k|) (C_k + e), with its own roundings, a dozen
 * at most to a term. */
static void set_bound(tp_filter *filter, const double errors[3], const tp_scaled *s) {
  filter->bound = 0;
  for (int row = 0; row < 3; row++) {
    const double size = fabs(filter->twist[row]);
    filter->bound +=
        size * s->error + (errors[row] + 2 * DBL_EPSILON * size) * (s->largest[row] + s->error);
  }
  filter->bound *= 1 + 16 * DBL_EPSILON;
}

/* Of a twist of moderate size that keeps its accuracy about the scaled program's point; false of
 * any other. */
static bool filter_by_doubles(tp_filter *filter, const tp_vector *twist, const tp_scaled *s) {
  static const double accurate = 0x1p-40, most = 0x1p300;
  enum { MOST_EXPONENT = 300 };
  if (s->length_exponent > MOST_EXPONENT || s->length_exponent < -MOST_EXPONENT) return false;
  const tp_near x = tp_ball_near(s->x), y = tp_ball_near(s->y);
  tp_near own[3];
  for (int row = 0; row < 3; row++) own[row] = tp_ball_near(twist->of + row);
  own[0] = tp_near_sub(own[0], tp_near_mul(own[2], y));
  own[1] = tp_near_add(own[1], tp_near_mul(own[2], x));
  own[2] = tp_near_mul(own[2], (tp_near){tp_two_to(s->length_exponent), 0});
  double size = 0, errors[3];
  for (int row = 0; row < 3; row++) {
    size = tp_larger(size, fabs(own[row].value));
    errors[row] = own[row].error;
    filter->twist[row] = own[row].value;
  }
  for (int row = 0; row < 3; row++) {
    if (!(errors[row] <= accurate * size)) return false;
  }
  set_bound(filter, errors, s);
  return size > 1 / most && size < most;
}

tp_filter tp_filter_of(const tp_vector *twist, const tp_scaled *s) {
  tp_filter filter = {.bound = 0};
  if (filter_by_doubles(&filter, twist, s)) return filter;
  double errors[3];
  tp_vector own;
  tp_vector_init(&own);
  tp_scaled_twist(&own, s, twist);
  const double log2_size = tp_vector_log2_size(&own);
  const long unit = isfinite(log2_size) ? (long)log2_size : 0;
  for (int row = 0; row < 3; row++) {
    arb_mul_2exp_si(own.of + row, own.of + row, -unit);
    filter.twist[row] = arf_get_d(arb_midref(own.of + row), ARF_RND_NEAR);
    const double size = fabs(filter.twist[row]);
    errors[row] = mag_get_d(arb_radref(own.of + row)) + size * DBL_EPSILON + DBL_MIN;
  }
  set_bound(&filter, errors, s);
  tp_vector_clear(&own);
  return filter;
}
