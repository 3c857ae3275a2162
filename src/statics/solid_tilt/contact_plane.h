/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points of one plane, of one friction: up to which slope of the load stays what forces
 * hold.
 *
 * With mass one, N the load across the plane and tau = t N along it, towards e; G at the height h
 * over its foot; c the point of the plane where the normal forces L of a motion act, u the slip
 * there, H the angular momentum of the acceleration a about c, and w the turn about the normal n.
 * The work of the load, as of a force at the point D from c where its line meets the plane, is
 *
 *     tau e . u + tau w e . (n x D) - N a_n(D),
 *
 * and moments about c are N n x D = H across n. Friction takes mu L |u| at least, as its points
 * slip by u in the mean. Where the foot of G is within the points L = N + a_n(foot) >= N, and where
 * forces hold the load a_n(D) >= 0 and mu >= t. So
 *
 *     a . M a <= t w e . H <= t / 2 sqrt((I + h^2 + R^2) J) a . M a,
 *
 * I the moment of inertia about e, J the inverse of inertia about n, R the farthest point from the
 * line along e through the foot; the last step is Cauchy and Schwarz' inequality, as w and e . H
 * are conjugate. No motion can begin where t is less than 2 / sqrt((I + h^2 + R^2) J). */

#ifndef TP_SOLID_TILT_CONTACT_PLANE_H
#define TP_SOLID_TILT_CONTACT_PLANE_H

#include "solid_tilt/contact_work.h"

/* Are the points a plane of one friction, the foot within them? False when memory is exhausted. */
TP_MUST_USE bool tp_contact_plane_find(bool *is_proven_plane, const tp_contact_work *work);

/* Is t of a load below that slope? On such a plane no motion can begin, if forces hold the load. */
bool tp_contact_plane_stays(const tp_contact_work *work, const tp_hold_load *load);

#endif
