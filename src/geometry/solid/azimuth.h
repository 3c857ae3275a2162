/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* East and north on a base whose upward direction is any: where the least turn brings it upright,
 * of the unit vector u = (a, b, c) to z,
 *     east = (1 - a a / (1 + c), -a b / (1 + c), -a),  north = (-a b / (1 + c), 1 - b b / (1 + c),
 * -b). Upside down, where no turn is the least, the turn about x: east = x, north = -y. */

#ifndef TP_SOLID_AZIMUTH_H
#define TP_SOLID_AZIMUTH_H

#include "number/near.h"
#include "topple.h"

typedef struct tp_map_frame {
  tp_near east[3], north[3];
} tp_map_frame;

/* `up` is not zero, of any length. */
void tp_map_frame_init(tp_map_frame *frame, const tp_near up[3]);

/* On a base that dips, whose normal is given by its components towards east, north and up in the
 * frame of `up`: there the least turn, brought back. Where `up` is not z that is another frame than
 * the one of the normal by itself. */
void tp_map_frame_down(tp_map_frame *frame, const tp_near up[3], const tp_near normal[3]);

/* The components of a vector. */
void tp_map_components(tp_near *east, tp_near *north, const tp_map_frame *frame,
                       const tp_near vector[3]);

/* Clockwise from north, in degrees from 0 to 360. */
tp_bounded tp_azimuth_of(tp_near east, tp_near north);

/* Sine and cosine of an azimuth in degrees, 0 to below 360. */
void tp_azimuth_direction(tp_near *east, tp_near *north, double azimuth_deg);

#endif
