/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Corrections of the normal force in the step of a contact's closing or opening, as derived in the
 * header, and the energy of a released shear spring. */

#include "contact_springs/crossing.h"

/* The displacement of the block along a direction at a contact, in a step. */
static double along(const tp_spring_contact *own, tp_xy direction, tp_xy displaced, double turned) {
  return tp_xy_dot(displaced, direction) + turned * tp_xy_cross(own->lever, direction);
}

static void push(tp_spring_forces *forces, const tp_spring_contact *own, double force) {
  const tp_xy normal = own->now.normal;
  forces->sum.x_n += force * normal.x;
  forces->sum.y_n += force * normal.y;
  forces->sum.moment_nm += force * tp_xy_cross(own->lever, normal);
}

/* (1 - u / d) / 2; 0 of one that did not begin or end within the step. */
static double missing_share(double overlap, double way) {
  return way > overlap ? (1 - overlap / way) / 2 : 0;
}

void tp_spring_closes(tp_spring_forces *forces, tp_spring_contact *own, tp_xy displaced,
                      double turned) {
  const double way = -along(own, own->now.normal, displaced, turned);
  const double less = own->normal_n * missing_share(-own->now.gap, way);
  own->normal_n -= less;
  push(forces, own, -less);
}

void tp_spring_opens(tp_spring_forces *forces, const tp_spring_contact *own, double normal_pa_m,
                     tp_xy displaced, double turned) {
  const double overlap = -own->now.gap;
  const double way = along(own, own->now.normal, displaced, turned);
  const double held = normal_pa_m * own->area * overlap;
  push(forces, own, -held * missing_share(overlap, way));
}

double tp_spring_let_go(const tp_spring_contact *own, double shear_pa_m, tp_xy displaced,
                        double turned) {
  const double sheared = own->sheared, way = along(own, own->tangent, displaced, turned);
  return shear_pa_m * own->area * sheared * (sheared + way) / 2;
}
