/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rank correlations of each number that varies, or is measured, with each quantity, over the
 * samples that have it; infinite quantities have their rank. */

#ifndef TP_STUDY_RANKS_H
#define TP_STUDY_RANKS_H

#include "study/tally.h"

TP_MUST_USE tp_status tp_tally_ranks(tp_study_result *result, const tp_tally *tally,
                                     tp_message *message);

#endif
