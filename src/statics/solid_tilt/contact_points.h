/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact points of a scene as cones of friction about the centroid of a solid. */

#ifndef TP_SOLID_TILT_CONTACT_POINTS_H
#define TP_SOLID_TILT_CONTACT_POINTS_H

#include "solid_contacts/friction_cones.h"
#include "solid_tilt/solid_given.h"
#include "solid_tilt/solid_moments.h"

typedef struct tp_contact_points {
  tp_friction_cones cones;
  fmpq_t length;   /* of the cones, in whole steps of the surface: a power of two */
  fmpq centre[3];  /* the centroid in such steps */
  double metres;   /* of a length of the cones */
  fmpq inertia[6]; /* integrals of x x, y y, z z, y z, z x, x y about the centroid over the mass */
} tp_contact_points;

/* Moments at the level exact. Also what results have of each, and notes on what looks wrong. To be
 * cleared also on failure. */
TP_MUST_USE tp_status tp_contact_points_init(tp_contact_points *points, tp_solid_contact *results,
                                             const tp_solid_moments *moments,
                                             const tp_solid_given *given, tp_notes *notes,
                                             tp_message *message);
void tp_contact_points_clear(tp_contact_points *points);

/* A point of the cones' lengths in the coordinates of the mesh. */
void tp_contact_points_given(double given[3], const tp_contact_points *points,
                             const tp_surface *surface, const double point[3]);

#endif
