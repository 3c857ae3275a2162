/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Printed minus derived: the difference of two rational functions in normal form, or of the
 * tangents of two angles. */

#include "verify/question.h"

#include "derive/field_work.h"
#include "verify/evaluate.h"

tp_status tp_question_difference(fmpz_mpoly_q_t difference, fmpz_mpoly_q_struct *derived,
                                 bool *rational, bool *tangents, const tp_question *q) {
  tp_subject *s = q->subject;
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t value;
  fmpz_mpoly_q_init(value, ring);
  bool both = false;
  *rational = *tangents = false;
  tp_status status = tp_evaluate_tangent(value, rational, q->quantity, s, q->message);
  if (status == TP_OK && *rational) {
    status = tp_evaluate_tangent(difference, &both, q->printed, s, q->message);
  }
  *tangents = both;
  if (status == TP_OK && !both) {
    status = tp_evaluate_field(value, rational, q->quantity, s, q->message);
    if (status == TP_OK) status = tp_evaluate_field(difference, &both, q->printed, s, q->message);
  }
  *rational = *rational && both;
  if (status == TP_OK && *rational) {
    tp_field_sub(difference, difference, value, field);
    tp_subject_reduce(difference, s);
    if (derived != NULL) fmpz_mpoly_q_swap(derived, value, field->ring);
    const char *problem = tp_field_problem(field);
    if (problem != NULL) {
      status = tp_formula_fail(q->printed, tp_formula_root(q->printed), q->message, problem);
    }
  }
  fmpz_mpoly_q_clear(value, ring);
  return status;
}
