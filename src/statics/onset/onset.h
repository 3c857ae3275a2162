/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion of a case (mechanics section 6a), with the base and the friction of the
 * scene. */

#ifndef TP_ONSET_ONSET_H
#define TP_ONSET_ONSET_H

#include "evaluation/direction_ball.h"
#include "evaluation/further.h"
#include "linear_program/cones.h"
#include "number/judge.h"

/* What the verdict takes from it. */
typedef struct tp_onset_found {
  arb_t degrees;     /* where the kind says that there is an angle */
  tp_answer at_tilt; /* can a motion begin at the scene's tilt? */
} tp_onset_found;

void tp_onset_found_init(tp_onset_found *found);
void tp_onset_found_clear(tp_onset_found *found);

/* Fills in the onset of the case, and the same at further tilts; takes the contact that the limit
 * left in `cones`, if any. False when memory is exhausted. */
TP_MUST_USE bool tp_evaluate_onset(const tp_evaluation *evaluation, tp_case *result,
                                   tp_onset_found *found, const tp_further_tilts *tilts,
                                   tp_cones *cones, tp_certainty *certainty);
void tp_onset_clear(tp_onset *onset);

/* Where the onset lies beside the limit, once both are certain; it never lies above it. */
void tp_onset_meet_limit(tp_case *result, const tp_evaluation *evaluation, tp_onset_found *found,
                         const tp_direction_ball *limit, tp_certainty *certainty);

#endif
