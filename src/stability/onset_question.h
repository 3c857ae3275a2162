/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact, the block's inertia and its loads put as a question to motion/. */

#ifndef TP_ONSET_QUESTION_H
#define TP_ONSET_QUESTION_H

#include "motion/motion.h"
#include "stability/evaluation.h"

/* The friction of the cones is left at zero. False when memory is exhausted. */
TP_MUST_USE bool tp_onset_question_init(tp_motion_question *question, tp_cones *cones,
                                        const tp_evaluation *evaluation, tp_direction towards);
void tp_onset_question_clear(tp_motion_question *question, tp_cones *cones);

#endif
