/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does a block that lets go from rest on a plane topple alone, or slide as well?
 *
 * G lies at r from the toe P, delta from the base's normal; k is the radius of gyration about G.
 * Turning about a toe that holds, it is accelerated by g r sin(a - delta) / (k^2 + r^2) at a tilt
 * a; of the weight's component across P-G, the share kappa = k^2 / (k^2 + r^2) is then left to the
 * toe, and all of that along P-G. Their resultant leans by delta + atan(kappa tan(a - delta)) from
 * the normal: beyond phi the toe slips. For phi < delta the slipping toe would turn the block back:
 * it slides and does not turn at all. */

#ifndef TP_DYNAMIC_BORDER_H
#define TP_DYNAMIC_BORDER_H

#include "topple.h"

/* The tilt, degrees, beyond which a block slides and topples at once, delta <= phi; kappa > 0. */
double tp_dynamic_border_deg(double delta_deg, double kappa, double friction_deg);

/* kappa and delta of a case: false where the border does not apply, its base being no plane, its
 * corner rounded, or its governing pivot none. */
bool tp_dynamic_border_of(double *delta_deg, double *kappa, const tp_solution *solution,
                          const tp_case *own);

#endif
