/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The limit-state function over independent standard normal scores, its calls counted. */

#ifndef TP_STATISTICS_STANDARD_SPACE_H
#define TP_STATISTICS_STANDARD_SPACE_H

#include "statistics/reliability.h"

typedef struct tp_standard_space {
  const tp_reliability *problem;
  double *factor; /* of the copula; NULL: independent */
  double *points; /* what the function is asked at */
  size_t room;
  uint64_t calls; /* points asked so far */
} tp_standard_space;

/* To ask at no more than `room` points at once. Left to tp_standard_space_clear. */
tp_status tp_standard_space_init(tp_standard_space *space, const tp_reliability *problem,
                                 size_t room, tp_message *message) TP_MUST_USE;
void tp_standard_space_clear(tp_standard_space *space);

/* The variables at the scores. */
void tp_standard_space_point(const tp_standard_space *space, double *x, const double *z);

/* g at `count` points of scores, no more than there is room for. */
tp_status tp_standard_space_values(tp_standard_space *space, double *g, const double *z,
                                   size_t count, tp_message *message) TP_MUST_USE;

#endif
