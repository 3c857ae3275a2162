/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is told of a block that was solved, and which of two is worse. */

#ifndef TP_SURVEY_JUDGE_H
#define TP_SURVEY_JUDGE_H

#include "topple_batch.h"
#include "topple_solution.h"

/* Bad input where the scene gives no tilt, or no friction: nothing is said of whether it stands.
 * The message has no place. */
TP_MUST_USE tp_status tp_batch_judge(tp_batch_row *row, const tp_solution *solution,
                                     tp_message *message);

/* By standing, by the factor over that required, by name, by line: below 0 where `one` is worse. */
int tp_batch_compare(const void *one, const void *other);

#endif
