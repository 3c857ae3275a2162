/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How long the contact is, how much of the underside that is, and what presses on each part of it.
 */

#ifndef TP_EVALUATION_CONTACT_LENGTH_H
#define TP_EVALUATION_CONTACT_LENGTH_H

#include "evaluation/evaluation.h"

/* In lattice units: the sum of the lengths of the facets, in doubles with a bound where the rung
 * has no more, or in balls; and that along the mean plane. */
void tp_contact_length(arb_t length, const tp_evaluation *evaluation);
void tp_contact_length_in_balls(arb_t length, const tp_evaluation *evaluation);
void tp_contact_nominal_length(arb_t length, const tp_evaluation *evaluation);

/* Contact ratio of a block on a profile: of the edges of its sole (problem/sole.h) the share
 * along the mean plane, 0 to 1, that lies on the base. False where it has no sole. */
bool tp_contact_ratio(arb_t ratio, const tp_evaluation *evaluation);

/* The block's weight over a length times the thickness, Pa. */
void tp_weight_per_area(arb_t pascal, const tp_evaluation *evaluation, const arb_t length_m);

#endif
