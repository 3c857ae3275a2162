/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The zeros of functions of the tilt.
 *
 * A cos a + B sin a + C = R cos(a - psi) + C has its zeros at psi +- acos(-C / R), in closed form.
 * With terms in 1 / cos a the function is taken times cos a or cos^2 a, which is bounded, and its
 * zeros are isolated by interval bisection: a box over which it or its derivative has no zero is
 * settled, any other is halved; then each is narrowed by Newton's steps in intervals.
 */

#ifndef TP_LOAD_ZEROS_H
#define TP_LOAD_ZEROS_H

#include "load/roots.h"
#include "load/wrench.h"

/* The zeros between -90 and 90 degrees. */
void tp_roots_find(tp_roots *roots, const tp_trig *f, long bits);

#endif
