/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical tilt of a solid as it lies, towards every azimuth.
 *
 * With H the height of the centroid, a the arm of an edge and n its unit vector outwards, the solid
 * tilted towards the unit vector u topples about the edge at tan alpha = a / (H n . u), where
 * n . u > 0; about the one for which this is the least. So 1 / tan alpha(u) is the largest of
 * H (n / a) . u over all edges: what the support is seen to reach along u, inverted in a circle. On
 * a plane base with friction the solid slides at phi, and moves at the lesser of both. */

#ifndef TP_SOLID_TILT_ROSE_H
#define TP_SOLID_TILT_ROSE_H

#include "solid_tilt/support.h"

/* What is asked of a band. */
typedef struct tp_rose_question {
  const tp_centre *centre;
  const tp_heights_above *above;
  double metres_per_step; /* metres for one of the surface's `near` */
  bool has_friction;
  double friction_angle_deg;
  size_t azimuths;
  const struct tp_stance_loads *loads; /* of a scene; NULL: there is none */
} tp_rose_question;

/* All of a band but the band itself. `*told` becomes false where the level does not tell. */
TP_MUST_USE tp_status tp_rose_of_band(tp_solid_band *result, const tp_rose_question *question,
                                      const fmpq_t band, bool *told, tp_message *message);

/* What it points to. */
void tp_solid_band_clear(tp_solid_band *band);

#endif
