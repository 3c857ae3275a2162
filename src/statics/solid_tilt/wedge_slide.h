/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of a wedge against sliding (Hoek and Bray, Rock Slope Engineering, 3rd ed.
 * 1981), in balls.
 *
 * R is the weight, less k_v of it, with k_h of it towards the azimuth of an earthquake, and the
 * water's pressure p times areas, into the wedge along a, b and across the crack. Along the unit
 * vector l down the line of both joints, with k = a . b, -R = N_a a + N_b b - S l:  N_a = (-R . a +
 * k R . b) / (1 - k^2), likewise N_b;  S = R . l, F = (c_a A_a + c_b A_b + N_a tan(phi_a) + N_b
 * tan(phi_b)) / S. An earthquake can make S < 0: then it slides up the line, and |S| counts. Where
 * N_b < 0 it leaves B and slides on A, as long as that takes it away from B: N_a = -R . a,  S = |R
 * + N_a a|,  F = (c_a A_a + N_a tan(phi_a)) / S. */

#ifndef TP_SOLID_TILT_WEDGE_SLIDE_H
#define TP_SOLID_TILT_WEDGE_SLIDE_H

#include "solid_tilt/wedge_shape.h"
#include "topple.h"

void tp_wedge_slide(tp_solid_wedge *result, const tp_wedge_shape *shape, const tp_scene *scene);

#endif
