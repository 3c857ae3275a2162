/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Values of the symbols of a subject, and of rational functions there. */

#ifndef TP_VERIFY_SAMPLE_H
#define TP_VERIFY_SAMPLE_H

#include "verify/subject.h"

/* Values of the field's symbols, and which of them the scene or the claim gives. */
typedef struct tp_claim_sample {
  long count;
  fmpq *values;
  bool *given;
} tp_claim_sample;

/* The subject's own; false when memory is exhausted. */
TP_MUST_USE bool tp_sample_init(tp_claim_sample *sample, const tp_subject *subject);
TP_MUST_USE bool tp_sample_init_copy(tp_claim_sample *sample, const tp_claim_sample *other);
void tp_sample_clear(tp_claim_sample *sample);

/* Set a symbol or an angle by its name; bad input where it is none. */
TP_MUST_USE tp_status tp_sample_set(tp_claim_sample *sample, const tp_subject *subject,
                                    const char *name, const fmpq_t value, tp_place place,
                                    tp_message *message);

/* The field's symbol that a name of a sample's value is; -1: none. */
long tp_sample_symbol(const tp_subject *subject, const char *name);

/* The field's symbols in balls; the caller clears the vector of sample->count. The angle i is that
 * of the facet at the pivot unless it is given. */
arb_ptr tp_sample_balls(const tp_claim_sample *sample, tp_subject *subject, long bits);

/* A rational function at the sample. */
void tp_sample_evaluate(arb_t value, const fmpz_mpoly_q_t formula, const tp_claim_sample *sample,
                        tp_subject *subject, long bits);

/* "a = 30, b = 120, alpha = 20" for the symbols that `used` marks. */
void tp_sample_text(char *text, size_t size, const tp_claim_sample *sample,
                    const tp_subject *subject, const int *used);

#endif
