/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "certificate/filter.h"

#include <float.h>
#include <math.h>

tp_filter tp_filter_of(const tp_vector *twist, const tp_scaled *s) {
  tp_filter filter = {.bound = 0};
  tp_vector own;
  tp_vector_init(&own);
  tp_scaled_twist(&own, s, twist);
  const double log2_size = tp_vector_log2_size(&own);
  const long unit = isfinite(log2_size) ? (long)log2_size : 0;
  for (int row = 0; row < 3; row++) {
    arb_mul_2exp_si(own.of + row, own.of + row, -unit);
    filter.twist[row] = arf_get_d(arb_midref(own.of + row), ARF_RND_NEAR);
    const double size = fabs(filter.twist[row]);
    const double error = mag_get_d(arb_radref(own.of + row)) + size * DBL_EPSILON + DBL_MIN;
    filter.bound +=
        size * s->error + (error + 2 * DBL_EPSILON * size) * (s->largest[row] + s->error);
  }
  filter.bound *= 1 + 16 * DBL_EPSILON; /* its own roundings, a dozen at most to a term */
  tp_vector_clear(&own);
  return filter;
}
