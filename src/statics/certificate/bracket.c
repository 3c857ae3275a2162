/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Limit enclosed between two tilts at 2^-e degrees to either side of the number found: equilibrium
 * proven below, an admissible twist above; e is lowered until both proofs succeed
 * (docs/mechanics.md section 6, step 1). */

#include "certificate/bracket.h"

#include "certificate/infeasible.h"
#include "certificate/interval.h"

/* At `middle` minus and plus 2^exponent, exactly. */
static tp_answer prove_at(const tp_limit_question *q, tp_scaled *scaled, const tp_vector *push,
                          const arf_t middle, slong exponent) {
  arb_t width, end;
  arb_init(width);
  arb_init(end);
  arb_one(width);
  arb_mul_2exp_si(width, width, exponent);
  arb_set_arf(end, middle);
  arb_sub(end, end, width, ARF_PREC_EXACT);
  tp_answer answer = tp_interval_bears_at(q, scaled, push, end);
  if (answer == TP_YES) {
    arb_set_arf(end, middle);
    arb_add(end, end, width, ARF_PREC_EXACT);
    answer = tp_infeasible_at(q, scaled, push, end);
  }
  arb_clear(width);
  arb_clear(end);
  return answer;
}

tp_answer tp_bracket_limit(tp_limit_answer *answer, const tp_limit_question *question,
                           tp_scaled *scaled) {
  enum { WIDER = 8 }; /* bits a round: at most bits / 32 rounds */
  const long bits = question->judge.bits;
  tp_limit_question strict = *question;
  strict.judge.settled = false;
  tp_vector push;
  arf_t middle;
  tp_vector_init(&push);
  arf_init(middle);
  arf_set_round(middle, arb_midref(answer->degrees), bits, ARF_RND_NEAR);
  tp_equilibrium_push(&push, &strict, scaled);
  tp_answer proven = TP_OPEN;
  for (slong exponent = -bits / 2; exponent <= -bits / 4 && proven != TP_YES; exponent += WIDER) {
    proven = prove_at(&strict, scaled, &push, middle, exponent);
    if (proven != TP_YES) continue;
    arb_set_arf(answer->degrees, middle);
    arb_add_error_2exp_si(answer->degrees, exponent);
    answer->bracketed = true;
  }
  tp_vector_clear(&push);
  arf_clear(middle);
  return proven == TP_YES ? TP_YES : TP_OPEN;
}
