/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What contact forces have to hold, put as a question to limit/. */

#ifndef TP_STATIC_LIMIT_LIMIT_ASKED_H
#define TP_STATIC_LIMIT_LIMIT_ASKED_H

#include "evaluation/evaluation.h"
#include "limit/limit.h"

/* A question and what it points to. */
typedef struct tp_limit_asked {
  tp_limit_question question;
  tp_wrench load;
  bool took_zero; /* by its judge */
} tp_limit_asked;

/* How a rung of the ladder judges balls about zero. */
tp_judge tp_limit_asked_judge(const tp_evaluation *evaluation);

/* `back`: tilted the other way. The cones are borrowed, and its own friction is theirs. */
void tp_limit_asked_init(tp_limit_asked *asked, const tp_cones *cones,
                         const tp_evaluation *evaluation, tp_direction towards, bool back);
void tp_limit_asked_clear(tp_limit_asked *asked);

#endif
