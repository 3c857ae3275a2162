/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The points of a domain at which a claim is looked at, one after the other. */

#ifndef TP_VERIFY_POINTS_H
#define TP_VERIFY_POINTS_H

#include "verify/branches.h"
#include "verify/question.h"

enum { TP_POINTS_WIDE = 40, TP_MOST_ROOTS = 64, TP_MOST_DIRECTIONS = 8 };

/* A zero of what a branch turns on, along one symbol. */
typedef struct tp_zero {
  long symbol;
  fmpq_t value;
} tp_zero;

typedef struct tp_points {
  const tp_question *question;
  unsigned at;  /* of all points, those left out among them */
  double units; /* of work, for one */
  bool failed;  /* memory was exhausted */
  long zero_count;
  tp_zero zeros[TP_MOST_ROOTS];
  long direction_count;
  const tp_name *directions[TP_MOST_DIRECTIONS];
  int quadrants[TP_MOST_DIRECTIONS];
} tp_points;

/* `branches` NULL: none. */
TP_MUST_USE tp_status tp_points_init(tp_points *points, const tp_question *question,
                                     const tp_branches *branches);
void tp_points_clear(tp_points *points);

/* The next point; false after the last. */
bool tp_points_next(tp_claim_sample *sample, tp_points *points);

#endif
