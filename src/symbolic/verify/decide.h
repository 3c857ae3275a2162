/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Deciding claims: formulas by identity or at points, numbers by their digits. */

#ifndef TP_VERIFY_DECIDE_H
#define TP_VERIFY_DECIDE_H

#include "verify/branches.h"
#include "verify/question.h"

/* Fill in the verdict and what belongs to it. */
TP_MUST_USE tp_status tp_decide_formula(tp_claim_result *result, const tp_question *question);
TP_MUST_USE tp_status tp_decide_number(tp_claim_result *result, const tp_question *question);

/* The verdict from points of the domain, on both sides of what the branches turn on: refuted, or
 * agrees, or undecided. */
TP_MUST_USE tp_status tp_decide_at_points(tp_claim_result *result, const tp_question *question,
                                          const tp_branches *branches);

/* Values at which both sides are certain to differ, if some are found. */
TP_MUST_USE tp_status tp_decide_witness(tp_claim_result *result, const tp_question *question);

/* Is a text a number as papers print it: [<|>|<=|>=] [sign] decimal? */
bool tp_decide_is_number(const char *text);

#endif
