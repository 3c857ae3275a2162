/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/certify.h"

static void set_range(arb_t degrees, const tp_limit_question *q) {
  arb_t pi;
  arb_init(pi);
  arb_const_pi(pi, q->judge.bits);
  arb_mul_ui(degrees, q->range, 180, q->judge.bits);
  arb_div(degrees, degrees, pi, q->judge.bits);
  arb_clear(pi);
}

/* The end of what is to hold; the range's own is to be borne itself. */
static tp_answer set_end(arb_t end, const tp_limit_question *q, tp_sketch *sketch,
                         const tp_vector *push, const tp_limit_answer *limit) {
  if (limit != NULL) {
    arb_set(end, limit->degrees);
    return TP_YES;
  }
  set_range(end, q);
  return tp_stretch_bears_at(q, sketch, push, end) == TP_YES ? TP_YES : TP_OPEN;
}

/* The limit itself is borne, so where it is level ground as near as can be told there is nothing
 * before it. */
static bool is_level(const arb_t start, const arb_t end, const tp_limit_question *q) {
  return start == NULL && arb_contains_zero(end) && q->judge.settled;
}

tp_answer tp_certify_holds(tp_search_tilts *tilts, const tp_limit_question *q, tp_sketch *sketch,
                           const arb_t start, const tp_limit_answer *limit) {
  tp_vector push;
  arb_t low, high;
  double held = 0, lost = 0;
  tp_vector_init(&push);
  arb_init(low);
  arb_init(high);
  tp_balance_push(&push, q, sketch);
  tp_answer answer = set_end(high, q, sketch, &push, limit);
  if (answer == TP_YES && !is_level(start, high, q)) {
    if (start != NULL) {
      arb_set(low, start);
    } else if (tp_stretch_bears_at(q, sketch, &push, low) != TP_YES) {
      answer = TP_OPEN;
    }
    if (!arb_lt(low, high)) answer = TP_OPEN;
    if (answer == TP_YES) {
      answer = tp_stretch_holds(&held, &lost, q, sketch, &push, low, high);
    }
    if (answer == TP_NO) tilts->lets_go = tp_search_between(sketch, q, held, lost);
  }
  tp_vector_clear(&push);
  arb_clear(low);
  arb_clear(high);
  return answer;
}

tp_answer tp_certify_beaten(const tp_limit_question *q, tp_sketch *sketch,
                            const tp_limit_answer *limit, bool to_level) {
  tp_vector push;
  arb_t end;
  tp_vector_init(&push);
  arb_init(end);
  tp_balance_push(&push, q, sketch);
  if (!to_level) set_range(end, q);
  const tp_answer answer =
      tp_stretch_is_beaten_after(&limit->face, q, sketch, &push, limit->degrees, end);
  tp_vector_clear(&push);
  arb_clear(end);
  return answer;
}

tp_answer tp_certify_never(const tp_limit_question *q, tp_sketch *sketch) {
  tp_vector push;
  arb_t low, high;
  tp_vector_init(&push);
  arb_init(low);
  arb_init(high);
  tp_balance_push(&push, q, sketch);
  set_range(high, q);
  arb_neg(low, high);
  const tp_answer answer = tp_stretch_is_beaten(q, sketch, &push, low, high);
  tp_vector_clear(&push);
  arb_clear(low);
  arb_clear(high);
  return answer;
}
