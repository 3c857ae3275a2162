/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/filter.h"

#include <float.h>
#include <math.h>

/* The twist about the point of the sketch's moments, lengths by its unit. */
static void to_sketch(tp_vector *own, const tp_vector *twist, const tp_sketch *s) {
  const arb_struct *v = twist->of;
  arb_mul(own->of, v + 2, s->y, s->bits);
  arb_sub(own->of, v, own->of, s->bits);
  arb_mul(own->of + 1, v + 2, s->x, s->bits);
  arb_add(own->of + 1, v + 1, own->of + 1, s->bits);
  arb_mul_2exp_si(own->of + 2, v + 2, s->length_exponent);
}

tp_filter tp_filter_of(const tp_vector *twist, const tp_sketch *s) {
  tp_filter filter = {.bound = 0};
  tp_vector own;
  tp_vector_init(&own);
  to_sketch(&own, twist, s);
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
  filter.bound *= 1 + 16 * DBL_EPSILON; /* its own roundings */
  tp_vector_clear(&own);
  return filter;
}
