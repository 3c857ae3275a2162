/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on the contact points of its scene: what it does at its tilt, and up to which tilt it is
 * held towards every azimuth.
 *
 * By t = tan(tilt) towards an azimuth, the loads that are held are a convex set about the foot of
 * the vertical. So of the least of all azimuths two bounds follow: the points that are proven to be
 * held are the corners of a polygon that is held, and each motion that is proven to begin bounds
 * the set by a line. Azimuths are added where the polygon is nearest to the foot. */

#ifndef TP_SOLID_TILT_ON_CONTACTS_H
#define TP_SOLID_TILT_ON_CONTACTS_H

#include "solid_tilt/solid_given.h"
#include "solid_tilt/solid_moments.h"

/* Where its scene gives contacts, into the solid; equilibrium is exact, and so are centroid and
 * inertia for it: moments at the level exact. */
TP_MUST_USE tp_status tp_on_contacts_find(tp_solid *solid, const tp_solid_moments *moments,
                                          const tp_solid_given *given, tp_message *message);
/* The same of the contacts that are given, into results of zeros, to be cleared also on failure. */
TP_MUST_USE tp_status tp_on_contacts_solve(tp_solid_contacts *results, tp_notes *notes,
                                           const tp_solid_moments *moments,
                                           const tp_solid_given *given, tp_message *message);
/* What tables of many scenes have of them. */
void tp_on_contacts_row(tp_solid_band *row, const tp_solid_contacts *contacts);
void tp_solid_contacts_clear(tp_solid_contacts *contacts);

#endif
