/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The powers of columns on a twist in doubles, with a bound: most columns of a large contact are
 * known to do work against it without a ball.
 *
 * In the scaled program's units the power of a column c is v . c, times a power of two. With a
 * bound e of the entries' error, C of their size, and r of the error of v,
 *
 *     |v . c - fl(v . c)| <= sum |v_k| e + (r_k + 4 u |v_k|) (C_k + e),   u = 2^-53. */

#ifndef TP_CERTIFICATE_FILTER_H
#define TP_CERTIFICATE_FILTER_H

#include "linear_program/scaled.h"
#include "plane/vector.h"

typedef struct tp_filter {
  double twist[3];
  double bound; /* a power above it is above zero */
} tp_filter;

tp_filter tp_filter_of(const tp_vector *twist, const tp_scaled *scaled);

static inline bool tp_filter_is_above_zero(const tp_filter *filter, const double column[3]) {
  return filter->twist[0] * column[0] + filter->twist[1] * column[1] +
             filter->twist[2] * column[2] >
         filter->bound;
}

#endif
