/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proofs over a whole interval of tilts, a <= alpha <= b, for loads that do not all turn with the
 * tilt.
 *
 * The base bears a convex set of wrenches, so it bears what lies between three that it bears. With
 * m = (a + b) / 2 and r = (b - a) / 2 < 90 degrees,
 *
 *     B_0 = sin^2((b - alpha) / 2) / sin^2 r,   B_2 = sin^2((alpha - a) / 2) / sin^2 r,
 *     B_1 = 2 sin((b - alpha) / 2) sin((alpha - a) / 2) cos r / sin^2 r
 *
 * are not negative and sum to 1; 1, cos alpha and sin alpha are B_0 times their value at a, B_2
 * times that at b, and B_1 times 1, cos m / cos r, sin m / cos r: an arc lies in the triangle of
 * its ends and of the apex where its tangents meet. f = 1 / cos and 1 / cos^2, as functions of c =
 * cos alpha, differ from their chord by f''/2 (c - cos a)(c - cos b), and
 *
 *     (c - cos a)(c - cos b) = -4 sin((alpha + a) / 2) sin((alpha + b) / 2)
 *                                 sin((alpha - a) / 2) sin((b - alpha) / 2),
 *
 * that is at most B_1 max|f''| sin^2 r / cos r. So F(alpha) = B_0 F(a) + B_1 A + B_2 F(b), A the
 * apex within that ball: the base bears F over the interval if it bears F(a), A and F(b). */

#ifndef TP_CERTIFICATE_INTERVAL_H
#define TP_CERTIFICATE_INTERVAL_H

#include "certificate/equilibrium.h"

/* Does the base bear the loads at the tilt, in degrees? TP_NO is unproven. */
tp_answer tp_interval_bears_at(const tp_limit_question *question, tp_scaled *scaled,
                               const tp_vector *push, const arb_t degrees);

/* Does it bear them from the tilt `low` to `high`, bearing them at both? TP_NO, unproven: not at
 * the tilt `*lost` between, but at `*held` before it. */
tp_answer tp_interval_holds(double *held, double *lost, const tp_limit_question *question,
                            tp_scaled *scaled, const tp_vector *push, const arb_t low,
                            const arb_t high);

#endif
