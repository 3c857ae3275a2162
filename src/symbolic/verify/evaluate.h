/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Values of formulas about a subject: as rational functions, where they are some, and in balls. */

#ifndef TP_VERIFY_EVALUATE_H
#define TP_VERIFY_EVALUATE_H

#include "verify/sample.h"

/* The formula in the field, in normal form. `*rational` says whether it is a rational function of
 * the symbols, sines and cosines of multiples of angles included; `value` is set only then. Roots
 * of squares are taken positive at the subject's values. */
TP_MUST_USE tp_status tp_evaluate_field(fmpz_mpoly_q_t value, bool *rational,
                                        const tp_formula *formula, tp_subject *subject,
                                        tp_message *message);

/* The same of what the function at the root of a formula is taken of. */
TP_MUST_USE tp_status tp_evaluate_operand(fmpz_mpoly_q_t value, bool *rational,
                                          const tp_formula *formula, tp_subject *subject,
                                          tp_message *message);

/* The same of the tangent of a formula that is an angle: an arctangent, a derived direction, a sum
 * of multiples of angles. Of any other formula `*rational` is false. */
TP_MUST_USE tp_status tp_evaluate_tangent(fmpz_mpoly_q_t value, bool *rational,
                                          const tp_formula *formula, tp_subject *subject,
                                          tp_message *message);

/* The formula at a sample. With `strict`, symbols without a value are bad input. A value that is
 * not finite is left for the caller to judge. */
TP_MUST_USE tp_status tp_evaluate_ball(arb_t value, const tp_formula *formula, tp_subject *subject,
                                       const tp_claim_sample *sample, bool strict, long bits,
                                       tp_message *message);

/* Units of work (derive/field_work.h) that enclosing a formula takes, definitions included. */
double tp_evaluate_units(const tp_formula *formula, const tp_subject *subject, long bits);

#endif
