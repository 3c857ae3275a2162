/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The search for a mend, and what it tries: other texts of a formula. */

#ifndef TP_VERIFY_MEND_H
#define TP_VERIFY_MEND_H

#include "verify/question.h"

/* The smallest change of one sign, coefficient, exponent or name that makes a refuted formula an
 * identity; none where none is found. */
TP_MUST_USE tp_status tp_mend_find(tp_claim_result *result, const tp_question *question);

/* The name of the unknown in a text, spelt like no name of a paper. */
#define TP_MEND_UNKNOWN "the_mended_number"

/* The text of a formula with [begin, end) replaced; NULL when memory is exhausted. */
char *tp_mend_replaced(const tp_formula *formula, int begin, int end, const char *by);

/* Printed minus derived for another text; false where it cannot be formed, with `*failed` set if
 * that is for want of memory, else untouched. */
bool tp_mend_difference(fmpz_mpoly_q_t difference, bool *failed, const char *text,
                        const tp_question *question);

/* The rational numbers for which a text with the unknown in it may be an identity: new memory, the
 * caller clears and frees it. -1 when memory is exhausted. */
long tp_mend_solve(fmpq **roots, const char *text, const tp_question *question);

/* The text of a node for a message, with an ellipsis where it is longer. */
const char *tp_mend_part(char *out, size_t size, const tp_formula *formula, int begin, int end);

/* How simple a number is: denominators weigh more than what it is. */
double tp_mend_simplicity(const fmpq_t value);

/* A number in digits: a decimal where one stands for it, else a fraction. The same as it is written
 * into a formula. */
void tp_mend_digits(char *out, size_t size, const fmpq_t value, bool decimal);
void tp_mend_number(char *out, size_t size, const fmpq_t value, bool decimal);

#endif
