/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a summary says of single samples: of the first ones, and of those that make no scene. */

#ifndef TP_STUDY_SUMMARY_SAMPLES_H
#define TP_STUDY_SUMMARY_SAMPLES_H

#include "study/tally.h"

/* The share that moves at each power of two from 16 on, and at the end. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_summary_convergence(tp_study_result *result, const tp_tally *tally);

/* The first invalid samples, each with its numbers and why they make no scene. */
TP_MUST_USE tp_status tp_summary_invalid(tp_study_result *result, const tp_tally *tally,
                                         tp_message *message);

#endif
