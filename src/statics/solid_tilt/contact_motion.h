/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The screw that begins on contacts, as results have it. */

#ifndef TP_SOLID_TILT_CONTACT_MOTION_H
#define TP_SOLID_TILT_CONTACT_MOTION_H

#include "solid_tilt/contact_points.h"

/* Of a twist in the lengths of the cones, about the centroid: velocity, then rate of turning. */
void tp_contact_motion(tp_solid_motion *motion, const tp_contact_points *points,
                       const tp_surface *surface, const fmpq_t metres_per_unit,
                       const double twist[TP_WRENCH]);

#endif
