/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block at rest: which motions can begin (docs/mechanics.md section 6a, in doubles), and can
 * forces of its contacts hold it? Both can be so: then the forces that its history has left there
 * decide. */

#ifndef TP_RIGID_CONTACT_REST_H
#define TP_RIGID_CONTACT_REST_H

#include "rigid_contact/law.h"

/* The contacts that stay closed in some motion which the others allow, whatever the loads: their
 * count, into a list with room for all. n contacts cost O(n^2). */
long tp_rest_list(long *listed, const tp_law *law);

/* Told of each motion that can begin, x its acceleration; false ends the search. Of a law at rest:
 * `least` and `rest` 0, no slip given. Three independent equations leave no motion from rest, so
 * sets of up to two edges of the contacts listed are tried. */
void tp_rest_motions(const tp_law *law, const long *listed, long listed_count, tp_law_found found,
                     void *context);

/* The least tilt, from one on and below a right angle (radians), at which a motion can
 * begin where the loads are level cos(alpha) + upright sin(alpha), as the weight is; INFINITY:
 * none. With two edges or fewer everything is then linear in tan(alpha), so each set has one
 * interval of it; rounding makes that wider by some 1e-9 of itself, never narrower, and
 * those narrower than 1e-7 are left out. */
double tp_rest_next_tilt(const tp_law *law, const long *listed, long listed_count,
                         const double level[3], const double upright[3], double from);

/* Forces that hold the block, at most three of them not zero: lambda of both edges of each contact,
 * n - t tan(phi) first, in `factors` of twice the contacts. False where none do, within 1e-10 of
 * the loads. By non-negative least squares (Lawson and Hanson, Solving Least Squares Problems,
 * 1974, chapter 23). */
bool tp_rest_forces(double *factors, const tp_law *law);

#endif
