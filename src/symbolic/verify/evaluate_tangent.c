/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tangents of formulas that are angles, as rational functions: sums of angles by angles.h,
 * directions and names by their definitions. */

#include "verify/evaluate.h"

#include "derive/field_work.h"
#include "verify/angles.h"

/* The tangent of a name: of a direction, of an angle, of what it is defined by. */
static tp_status tangent_of_name(fmpz_mpoly_q_t value, bool *rational, long index,
                                 tp_subject *subject, tp_message *message) {
  const tp_field *field = subject->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const tp_name *name = NULL;
  const tp_status status = tp_subject_name(&name, subject, index, message);
  *rational = false;
  if (status != TP_OK) return status;
  if (name->kind == TP_NAME_DEFINITION) {
    return tp_evaluate_tangent(value, rational, &name->definition, subject, message);
  }
  if (name->kind == TP_NAME_DIRECTION && !fmpz_mpoly_q_is_zero(name->run, ring)) {
    tp_field_div(value, name->value, name->run, field);
    tp_subject_reduce(value, subject);
    *rational = true;
  }
  if (name->kind == TP_NAME_ANGLE) {
    fmpz_mpoly_q_t cosine;
    fmpz_mpoly_q_init(cosine, ring);
    fmpz_mpoly_q_gen(value, subject->angles[name->angle].sine, ring);
    fmpz_mpoly_q_gen(cosine, subject->angles[name->angle].cosine, ring);
    tp_field_div(value, value, cosine, field);
    fmpz_mpoly_q_clear(cosine, ring);
    *rational = true;
  }
  return TP_OK;
}

tp_status tp_evaluate_tangent(fmpz_mpoly_q_t value, bool *rational, const tp_formula *formula,
                              tp_subject *subject, tp_message *message) {
  const tp_formula_node *root = tp_formula_root(formula);
  if (root->kind == TP_FORMULA_NAME) {
    return tangent_of_name(value, rational, root->name, subject, message);
  }
  if (root->kind == TP_FORMULA_CALL && root->function == TP_FUNCTION_ATAN) {
    return tp_evaluate_operand(value, rational, formula, subject, message);
  }
  fmpz_mpoly_q_t angle;
  bool known = false, infinite = false;
  *rational = false;
  fmpz_mpoly_q_init(angle, subject->field->ring);
  const tp_status status = tp_evaluate_field(angle, &known, formula, subject, message);
  if (status == TP_OK && known && !fmpz_mpoly_q_is_fmpq(angle, subject->field->ring)) {
    *rational = tp_angle_tangent(value, &infinite, angle, subject) && !infinite;
  }
  fmpz_mpoly_q_clear(angle, subject->field->ring);
  return status;
}
