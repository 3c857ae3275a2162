/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One number, angle or point of a solution against the other's: for compare_solutions and
 * compare_limits. */

#ifndef TP_TEST_COMPARE_H
#define TP_TEST_COMPARE_H

#include "compare_solutions.h"

enum { COMPARE_BITS = 256 };

typedef struct comparison {
  const relation *r;
  char *why;
  const char *where;  /* which case */
  bool towards_right; /* it is */
} comparison;

/* Keeps the first `what` that does not hold. */
void compare_need(const comparison *c, bool holds, const char *what);

void compare_set_ball(arb_t ball, tp_bounded number);
void compare_ball(const comparison *c, const arb_t expected, tp_bounded number, const char *what);

/* The other is the one times the length to a power. */
void compare_number(const comparison *c, tp_bounded one, tp_bounded other, int power,
                    const char *what);

/* Row `row` of the map on (x, y). */
void compare_map_row(arb_t result, const relation *r, int row, const arb_t x, const arb_t y);
void compare_point(const comparison *c, const tp_bounded one[2], const tp_bounded other[2],
                   const char *what);

/* Towards the left the other is the one less the turn, in degrees; towards the right, and more. Of
 * pivots they go about all of a circle. */
void compare_angle(const comparison *c, tp_bounded one, tp_bounded other, const char *what);
void compare_fos(const comparison *c, tp_fos one, tp_fos other, const char *what);

/* Limits, sliding and verdict of a case; limits alone where a turn leaves nothing else. */
void compare_all_limits(const comparison *c, const tp_case *one, const tp_case *other);

/* The onset of motion of a case, where nothing is turned. */
void compare_onsets(const comparison *c, const tp_case *one, const tp_case *other);

#endif
