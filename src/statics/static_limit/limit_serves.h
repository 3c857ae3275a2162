/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the limit on the scene's base serve for the base as it is otherwise?
 *
 * One that goes on past the toe adds forces, one that ends there takes some away. A limit is proven
 * by the two forces that hold the block there and a twist that no force resists (certificate/
 * prove.h): where the base otherwise has both of these forces, and the twist is admissible to those
 * that it adds, it has the same limit. With both forces above zero no other twist is as good, so
 * that the mechanism is the same, too. */

#ifndef TP_STATIC_LIMIT_LIMIT_SERVES_H
#define TP_STATIC_LIMIT_LIMIT_SERVES_H

#include "evaluation/evaluation.h"
#include "limit/limit.h"

/* For loads that turn with the tilt and an answer proven without a tie or anything taken for zero.
 * False when memory is exhausted. */
TP_MUST_USE bool tp_limit_serves(bool *serves, const tp_evaluation *evaluation,
                                 tp_direction towards, const tp_limit_question *question,
                                 tp_limit_answer *answer);

#endif
