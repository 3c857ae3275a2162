/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The friction angle of the contact, which by Barton's law depends on the normal stress (Eq. 8),
 *
 *     phi = phi_r + JRC log10(JCS / sigma_n), at most 70 degrees (Barton and Choubey's range),
 *
 * and no less than phi_r: the logarithm is no less than 0, as joints whose asperities are crushed
 * keep the friction of their residual surface (Barton and Bandis 1990). sigma_n is the mean over
 * the contact's area on the mean plane, as in the paper's Table 2, or over the width that the scene
 * states: at a tilt alpha W cos(alpha) / S, under loads with what they add. */

#ifndef TP_EVALUATION_FRICTION_H
#define TP_EVALUATION_FRICTION_H

#include "evaluation/loaded.h"
#include "linear_program/cones.h"

bool tp_friction_is_load_dependent(const tp_evaluation *evaluation);

/* What an evaluation keeps of it: the stress on level ground by the weight alone, Pa, zero where
 * friction does not depend on it; tan(phi) where it does not. */
void tp_friction_stress_when_level(arb_t pascal, const tp_evaluation *evaluation);
void tp_friction_tangent_given(arb_t tangent, const tp_evaluation *evaluation);

/* Is tan(phi) divided by a partial factor? Wherever this header tells friction it is so divided. */
bool tp_friction_is_divided(const tp_evaluation *evaluation);
/* The angle of a facet where it is a rational number of degrees; NULL: it is not. */
const fmpq *tp_friction_exact(const tp_evaluation *evaluation, long facet);

/* The mean normal stress at a tilt in degrees, Pa, where friction depends on it. */
void tp_friction_stress_at(arb_t pascal, const tp_evaluation *evaluation, const arb_t tilt);

/* In degrees, at a tilt in degrees. */
void tp_friction_at(arb_t degrees, const tp_evaluation *evaluation, const arb_t tilt);

/* The angle that a facet of the contact has of its own in the scene; NULL: it has the scene's. */
const fmpq *tp_friction_own(const tp_problem *problem, long facet);
/* The same as tp_friction_at of a facet; `degrees` may be `tilt`. */
void tp_friction_of_facet(arb_t degrees, const tp_evaluation *evaluation, long facet,
                          const arb_t tilt);
/* tan(phi) of that. */
void tp_friction_facet_tangent(arb_t tangent, const tp_evaluation *evaluation, long facet,
                               const arb_t degrees);
/* tan(phi) of all facets that have their own, into cones as they are initialised. */
TP_MUST_USE bool tp_friction_take_own(tp_cones *cones, const tp_evaluation *evaluation);

/* tan(phi) over the divisor of a factored scene, and the angle of that. */
void tp_friction_divide_tangent(arb_t tangent, const tp_scene *scene, long bits);
void tp_friction_divide_angle(arb_t degrees, const tp_scene *scene, long bits);

/* tan(phi), exact at 0 and 45 degrees, the only rational angles with a rational tangent (Niven). */
void tp_friction_tangent(arb_t tangent, const arb_t degrees, long bits);

/* The same of an angle of friction of the scene, which tp_friction_at gave. */
void tp_friction_set_tangent(arb_t tangent, const tp_evaluation *evaluation, const arb_t degrees);

/* The tilt at which the block begins to move where the friction angle is `degrees`: to a few digits
 * where `tilt` is asked of as an estimate, else enclosed. False where there is none. */
typedef bool (*tp_friction_limit)(arb_t tilt, void *context, const arb_t degrees, bool estimate);

/* The friction angle at the tilt at which the block begins to move with it. There is one in an
 * interval of tilts that the limit maps into itself (Brouwer), and in one at whose lower end the
 * block holds with the friction there, and at its upper end not; false where none was found.
 * `back`: tilts count the other way. */
bool tp_friction_meet(arb_t degrees, const tp_evaluation *evaluation, tp_friction_limit limit,
                      void *context, bool back);

#endif
