/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tallies, outcomes and numbers of claims that all reports of a verification use. */

#ifndef TP_REPORT_CLAIMS_H
#define TP_REPORT_CLAIMS_H

#include "output/text.h"

bool tp_claim_objects(const tp_claim_result *claim);

/* "212 proven, 180 agree, …" */
void tp_claims_add_tally(tp_text *text, const tp_verification *verification);

typedef enum tp_claim_page { TP_CLAIM_PLAIN, TP_CLAIM_MARKDOWN } tp_claim_page;

/* What a formula that agrees in numbers, or a number, comes to in one line. */
void tp_claim_add_outcome(tp_text *text, const tp_claim_result *claim, tp_claim_page page);

/* A computed number with the decimals that a reader of the printed one wants: two more than are
 * printed, all certain. */
const char *tp_claim_number(char out[TP_NUMBER_SIZE], const tp_claim_result *claim,
                            tp_bounded number);

#endif
