/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is told of many blocks that a row makes. */

#ifndef TP_SURVEY_JUDGE_SYSTEM_H
#define TP_SURVEY_JUDGE_SYSTEM_H

#include "stability/severity.h"
#include "topple_batch.h"
#include "topple_block_system.h"

TP_MUST_USE tp_status tp_batch_judge_system(tp_batch_row *row, const tp_block_system *system,
                                            tp_message *message);

/* How urgent the direction is that governs: load cases of one scene are compared by it. */
tp_severity tp_batch_system_severity(const tp_block_system *system);

#endif
