/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Questions of sign put to balls: an answer, or that more bits are needed. A ball about zero is an
 * answer only by assumption, where it is as narrow as half the bits at hand and the rung is high
 * enough for that to be called a tie (docs/mechanics.md section 10). */

#ifndef TP_NUMBER_JUDGE_H
#define TP_NUMBER_JUDGE_H

#include <arb.h>
#include <stdbool.h>

typedef enum tp_answer { TP_NO, TP_YES, TP_OPEN } tp_answer;

/* How balls about zero are judged: one narrower than half the precision, relative to what it is
 * made of, is zero if `settled`; otherwise it is open. */
typedef struct tp_judge {
  long bits;      /* of roundings */
  long precision; /* of the data: bits, or more where they are exact */
  bool settled;
  bool *took_zero; /* becomes true where a sign rests on that; NULL: nobody asks */
} tp_judge;

/* A sign that the ball leaves open: none of 1, -1 and 0. */
enum { TP_OPEN_SIGN = 2 };

/* Sign of a ball by the judge: 1, -1, 0, or TP_OPEN_SIGN. `log2_scale` is that of its terms. */
int tp_judge_sign(const tp_judge *judge, const arb_t ball, double log2_scale);

/* Does that sign rest on the scale? Otherwise any will do. */
static inline bool tp_judge_asks_scale(const tp_judge *judge, const arb_t ball) {
  return judge->settled && arb_contains_zero(ball) && !arb_is_zero(ball);
}

/* Is what its bits do not tell apart to be taken for equal? Notes that it is. */
bool tp_judge_takes_equal(const tp_judge *judge);

#endif
