/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Deciding claims: formulas by identity or at points, numbers by their digits. */

#ifndef TP_DECIDE_H
#define TP_DECIDE_H

#include "verify/branches.h"

/* A claim made ready: what is printed about a quantity of a subject, at a sample. */
typedef struct tp_question {
  tp_subject *subject;
  const tp_formula *quantity, *printed; /* printed NULL where a number is printed */
  const char *number;                   /* as printed */
  tp_place number_place;
  const tp_sample *sample;
  tp_message *message;
} tp_question;

/* Fill in the verdict and what belongs to it. */
TP_MUST_USE tp_status tp_decide_formula(tp_claim_result *result, const tp_question *question);
TP_MUST_USE tp_status tp_decide_number(tp_claim_result *result, const tp_question *question);

/* Printed minus derived in the field, or of their tangents (`*tangents`) where both are angles;
 * `*rational` false: one of them is not rational. `derived` may be NULL. */
TP_MUST_USE tp_status tp_decide_difference(fmpz_mpoly_q_t difference, fmpz_mpoly_q_struct *derived,
                                           bool *rational, bool *tangents,
                                           const tp_question *question);

/* A formula in writing: by the tangent of an angle where sine and cosine come in no other way. */
TP_MUST_USE tp_status tp_decide_write(char **text, const fmpz_mpoly_q_t formula,
                                      const tp_question *question);

/* The smallest change of one sign, coefficient, exponent or name that makes a refuted formula an
 * identity; none where none is found. */
TP_MUST_USE tp_status tp_mend_find(tp_claim_result *result, const tp_question *question);

/* Do two angles of equal tangents have to be equal, by their ranges over the domain? */
bool tp_angles_in_reach(const tp_question *question);

/* The quadrant of a direction at a sample, 1 to 4; 0 where it is not known. */
int tp_direction_quadrant(const tp_name *name, const tp_sample *sample, tp_subject *subject);

/* The verdict from points of the domain, on both sides of what the branches turn on: refuted, or
 * agrees, or undecided. */
TP_MUST_USE tp_status tp_decide_at_points(tp_claim_result *result, const tp_question *question,
                                          const tp_branches *branches);

/* Values at which both sides are certain to differ, if some are found. */
TP_MUST_USE tp_status tp_decide_witness(tp_claim_result *result, const tp_question *question);

/* Is a text a number as papers print it: [<|>|<=|>=] [sign] decimal? */
bool tp_decide_is_number(const char *text);

#endif
