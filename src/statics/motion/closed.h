/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contacts that stay closed in a mode (motion/strata.h), and the forces that they can exert: n
 * and t tan(phi) against the slip of each, both edges where it sticks. Of a family of parallel
 * normals that slips, all forces of one friction have one direction, and the two with the least and
 * the largest moment span the rest. Every sign is judged in balls (number/judge.h). */

#ifndef TP_MOTION_CLOSED_H
#define TP_MOTION_CLOSED_H

#include "motion/mode.h"

typedef struct tp_closed {
  long edge_count, edge_room;
  tp_cone_edge *edges;
  bool sticks; /* one of them, with which the block turns about it */
} tp_closed;

void tp_closed_clear(tp_closed *closed);

/* Those of one ray: where its lines are told, of these alone. */
TP_MUST_USE tp_motion_outcome tp_closed_of_ray(tp_closed *closed, const tp_twists *twists, long ray,
                                               const tp_normals *normals);
tp_mechanism tp_closed_mechanism(const tp_closed *closed, const tp_ray *ray);

/* Those between two rays on a normal line, none of which sticks there. */
TP_MUST_USE tp_motion_outcome tp_closed_of_sector(tp_closed *closed, const tp_ray *from,
                                                  const tp_ray *to, long normal,
                                                  const tp_normals *normals);

/* The sense in which a point slips, up-dip 1 or down-dip -1; 0 where it sticks, TP_OPEN_SIGN. */
int tp_closed_slip(const tp_normals *normals, long point, const tp_ray *ray);

/* The same within a mode: the sense on the first of its rays on which the point slips. */
int tp_closed_slip_in(const tp_normals *normals, const tp_twists *twists, const tp_mode *mode,
                      long point);

#endif
