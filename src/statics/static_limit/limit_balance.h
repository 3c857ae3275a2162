/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All that acts on the block at a proven limit, and that it cancels. */

#ifndef TP_STATIC_LIMIT_LIMIT_BALANCE_H
#define TP_STATIC_LIMIT_LIMIT_BALANCE_H

#include "evaluation/certainty.h"
#include "limit/limit.h"

/* Weight and loads, cohesion and bonds that are used up, and the sum of these and of the two
 * reactions of the answer, which must be at an angle. */
void tp_limit_balance_find(tp_limit_balance *balance, const tp_evaluation *evaluation,
                           const tp_limit_question *question, const tp_limit_answer *answer,
                           tp_direction towards);

#endif
