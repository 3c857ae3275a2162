/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A question about a claim: is what is printed the quantity? */

#ifndef TP_VERIFY_QUESTION_H
#define TP_VERIFY_QUESTION_H

#include "verify/sample.h"

/* A claim made ready: what is printed about a quantity of a subject, at a sample. */
typedef struct tp_question {
  tp_subject *subject;
  const tp_formula *quantity, *printed; /* printed NULL where a number is printed */
  const char *number;                   /* as printed */
  tp_place number_place;
  const tp_claim_sample *sample;
  tp_message *message;
} tp_question;

/* Printed minus derived in the field, or of their tangents (`*tangents`) where both are angles;
 * `*rational` false: one of them is not rational. `derived` may be NULL. */
TP_MUST_USE tp_status tp_question_difference(fmpz_mpoly_q_t difference,
                                             fmpz_mpoly_q_struct *derived, bool *rational,
                                             bool *tangents, const tp_question *question);

/* A formula in writing: by the tangent of an angle where sine and cosine come in no other way. */
TP_MUST_USE tp_status tp_question_write(char **text, const fmpz_mpoly_q_t formula,
                                        const tp_question *question);

#endif
