/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proofs that complete a limit found in doubles: held from level up to it, or never held, over
 * intervals of tilts (docs/mechanics.md section 6, steps 2 and 3). No value near zero is taken for
 * zero here. */

#include "certificate/certify.h"

#include "certificate/infeasible.h"
#include "certificate/interval.h"

/* A proof takes nothing for zero that only is so as far as the bits tell. */
static tp_limit_question without_zeros(const tp_limit_question *question) {
  tp_limit_question strict = *question;
  strict.judge.settled = false;
  return strict;
}

/* Of a bracket m +- r, exactly: m - r, where the loads are borne, or m + r, where not. */
static void set_end_of_bracket(arb_t end, const tp_limit_answer *limit, bool held) {
  arf_t radius;
  arf_init(radius);
  arf_set_mag(radius, arb_radref(limit->degrees));
  if (held) arf_neg(radius, radius);
  arf_add(arb_midref(end), arb_midref(limit->degrees), radius, ARF_PREC_EXACT, ARF_RND_DOWN);
  mag_zero(arb_radref(end));
  arf_clear(radius);
}

void tp_certify_held_end(arb_t end, const tp_limit_answer *limit) {
  arb_set(end, limit->degrees);
  if (limit->bracketed) set_end_of_bracket(end, limit, true);
}

/* The end of what is to hold; the range's own is to be borne itself. */
static tp_answer set_end(arb_t end, const tp_limit_question *q, tp_scaled *scaled,
                         const tp_vector *push, const tp_limit_answer *limit) {
  if (limit != NULL) {
    tp_certify_held_end(end, limit);
    return TP_YES;
  }
  arb_set_d(end, q->range_deg);
  return tp_interval_bears_at(q, scaled, push, end) == TP_YES ? TP_YES : TP_OPEN;
}

/* The limit itself is borne, so where it is level ground as near as can be told there is nothing
 * before it. */
static bool is_level(const arb_t start, const arb_t end, const tp_limit_question *q) {
  return start == NULL && arb_contains_zero(end) && tp_judge_takes_equal(&q->judge);
}

tp_answer tp_certify_holds(double *held, double *lost, const tp_limit_question *question,
                           tp_scaled *scaled, const arb_t start, const tp_limit_answer *limit) {
  const tp_limit_question strict = without_zeros(question), *q = &strict;
  tp_vector push;
  arb_t low, high;
  tp_vector_init(&push);
  arb_init(low);
  arb_init(high);
  tp_equilibrium_push(&push, q, scaled);
  tp_answer answer = set_end(high, q, scaled, &push, limit);
  if (answer == TP_YES && !is_level(start, high, question)) {
    if (start != NULL) {
      arb_set(low, start);
    } else if (tp_interval_bears_at(q, scaled, &push, low) != TP_YES) {
      answer = TP_OPEN;
    }
    if (!arb_lt(low, high)) answer = TP_OPEN;
    if (answer == TP_YES) {
      answer = tp_interval_holds(held, lost, q, scaled, &push, low, high);
    }
  }
  tp_vector_clear(&push);
  arb_clear(low);
  arb_clear(high);
  return answer;
}

tp_answer tp_certify_infeasible(const tp_limit_question *question, tp_scaled *scaled,
                                const tp_limit_answer *limit) {
  const tp_limit_question strict = without_zeros(question), *q = &strict;
  tp_vector push;
  arb_t start, end;
  tp_vector_init(&push);
  arb_init(start);
  arb_init(end);
  tp_equilibrium_push(&push, q, scaled);
  arb_get_mid_arb(end, limit->degrees);
  arb_neg(end, end);
  if (limit->bracketed) set_end_of_bracket(start, limit, false);
  const tp_answer answer =
      limit->bracketed ? tp_infeasible(q, scaled, &push, start, end)
                       : tp_infeasible_after(&limit->face, q, scaled, &push, limit->degrees, end);
  tp_vector_clear(&push);
  arb_clear(start);
  arb_clear(end);
  return answer;
}

tp_answer tp_certify_never(const tp_limit_question *question, tp_scaled *scaled) {
  const tp_limit_question strict = without_zeros(question), *q = &strict;
  tp_vector push;
  arb_t low, high;
  tp_vector_init(&push);
  arb_init(low);
  arb_init(high);
  tp_equilibrium_push(&push, q, scaled);
  arb_set_d(high, q->range_deg);
  arb_neg(low, high);
  const tp_answer answer = tp_infeasible(q, scaled, &push, low, high);
  tp_vector_clear(&push);
  arb_clear(low);
  arb_clear(high);
  return answer;
}
