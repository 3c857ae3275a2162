/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least active force that gives a wedge a factor F, in its best direction.
 *
 * Down the line of both joints m(R) = C_a + C_b + N_a tan(phi_a) + N_b tan(phi_b) + F R . l is
 * linear in R, and grows along  g = F l - tan(phi_a) a* - tan(phi_b) b*,  a* = (a - k b) / (1 -
 * k^2), likewise b*. So no T with |T| < -m(R) / |g| makes m(R + T) >= 0, which a factor of F takes
 * while both joints are pressed; T = -m(R) g / |g|^2 does, and presses both. For one joint's
 * friction angle it is at the angle whose tangent is tan(phi) / F to the line, as for a slab. */

#ifndef TP_SOLID_TILT_WEDGE_SUPPORT_H
#define TP_SOLID_TILT_WEDGE_SUPPORT_H

#include "solid_tilt/wedge_law.h"
#include "topple.h"

/* At the values of the law under all loads. None where it slides otherwise, has the factor, or one
 * joint would not be pressed. */
void tp_wedge_support_find(tp_solid_wedge *wedge, const tp_wedge_law *law,
                           const tp_wedge_shape *shape, const arb_struct values[TP_WEDGE_LINES],
                           const fmpq_t factor);

#endif
