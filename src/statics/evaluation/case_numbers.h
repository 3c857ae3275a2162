/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a direction of tilt comes to, number by number, as rows of tables tell it. */

#ifndef TP_EVALUATION_CASE_NUMBERS_H
#define TP_EVALUATION_CASE_NUMBERS_H

#include "topple_solution.h"

typedef enum tp_case_state {
  TP_CASE_UNKNOWN, /* not asked for, not decided, or not applicable */
  TP_CASE_NUMBER,
  TP_CASE_ALWAYS, /* it holds at every tilt, or nothing overturns it */
  TP_CASE_NEVER   /* it holds at none */
} tp_case_state;

/* The critical angle by moments about the governing pivot, the onset, the static limit; `*value`
 * where it is a number. */
tp_case_state tp_case_moments_deg(tp_bounded *value, const tp_case *own);
tp_case_state tp_case_onset_deg(tp_bounded *value, const tp_case *own);
tp_case_state tp_case_limit_deg(tp_bounded *value, const tp_case *own);

/* The governing factor of safety: one that is but an upper bound, since another is undecided, is
 * none. */
tp_case_state tp_case_fos(tp_bounded *value, const tp_case *own);

/* The factor by moments, about the least safe pivot of those that count or else of all, and that of
 * shear strength along the facet that slides. */
tp_case_state tp_case_fos_moments(tp_bounded *value, const tp_case *own);
tp_case_state tp_case_fos_sliding(tp_bounded *value, const tp_case *own);

/* The factor that governs, or NULL. */
const tp_factor *tp_case_factor(const tp_case *own);

#endif
