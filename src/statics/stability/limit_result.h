/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A proven limit as result fields: mechanism, centre, facet and reactions. */

#ifndef TP_STABILITY_LIMIT_RESULT_H
#define TP_STABILITY_LIMIT_RESULT_H

#include "limit/limit.h"
#include "stability/certainty.h"

/* How a face moves, in the words of the field. */
tp_mechanism tp_limit_mechanism(tp_face_motion motion);

/* Fill in all but base_beyond_toe; notes in the evaluation what is not certain enough. */
void tp_limit_describe(tp_limit *result, const tp_evaluation *evaluation,
                       const tp_limit_question *question, const tp_limit_answer *answer,
                       tp_direction towards, tp_certainty *certainty);

#endif
