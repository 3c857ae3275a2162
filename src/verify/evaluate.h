/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Values of formulas about a subject: as rational functions, where they are some, and in balls. */

#ifndef TP_EVALUATE_H
#define TP_EVALUATE_H

#include "verify/subject.h"

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

/* Sine and cosine of a rational function that is a whole multiple of angles and right angles; false
 * where it is none. */
bool tp_angle_sine_cosine(fmpz_mpoly_q_t sine, fmpz_mpoly_q_t cosine, const fmpz_mpoly_q_t angle,
                          const tp_subject *subject);
/* Its tangent, for halves of angles too; `*infinite`: a right angle. */
bool tp_angle_tangent(fmpz_mpoly_q_t tangent, bool *infinite, const fmpz_mpoly_q_t angle,
                      const tp_subject *subject);

/* Values of the field's symbols, and which of them the scene or the claim gives. */
typedef struct tp_sample {
  long count;
  fmpq *values;
  bool *given;
} tp_sample;

/* The subject's own; false when memory is exhausted. */
TP_MUST_USE bool tp_sample_init(tp_sample *sample, const tp_subject *subject);
TP_MUST_USE bool tp_sample_init_copy(tp_sample *sample, const tp_sample *other);
void tp_sample_clear(tp_sample *sample);

/* Set a symbol or an angle by its name; bad input where it is none. */
TP_MUST_USE tp_status tp_sample_set(tp_sample *sample, const tp_subject *subject, const char *name,
                                    const fmpq_t value, tp_place place, tp_message *message);

/* The field's symbol that a name of a sample's value is; -1: none. */
long tp_sample_symbol(const tp_subject *subject, const char *name);

/* The field's symbols in balls; the caller clears the vector of sample->count. The angle i is that
 * of the facet at the pivot unless it is given. */
arb_ptr tp_sample_balls(const tp_sample *sample, tp_subject *subject, long bits);

/* A rational function at the sample. */
void tp_sample_evaluate(arb_t value, const fmpz_mpoly_q_t formula, const tp_sample *sample,
                        tp_subject *subject, long bits);

/* "a = 30, b = 120, alpha = 20" for the symbols that `used` marks. */
void tp_sample_text(char *text, size_t size, const tp_sample *sample, const tp_subject *subject,
                    const int *used);

/* The formula at a sample. With `strict`, symbols without a value are bad input. A value that is
 * not finite is left for the caller to judge. */
TP_MUST_USE tp_status tp_evaluate_ball(arb_t value, const tp_formula *formula, tp_subject *subject,
                                       const tp_sample *sample, bool strict, long bits,
                                       tp_message *message);

/* Units of work (derive/field_work.h) that enclosing a formula takes, definitions included. */
double tp_evaluate_units(const tp_formula *formula, const tp_subject *subject, long bits);

/* Mark the field's symbols that a formula depends on. */
TP_MUST_USE tp_status tp_evaluate_used(int *used, const tp_formula *formula, tp_subject *subject,
                                       tp_message *message);

#endif
