/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a block lies in water that is sited: which way is up in the frame of its problem, at the
 * scene's tilt, and what it is wetted by there.
 *
 * In the frame of the world the level and the surface are those of the coordinates, which the
 * problem turned by an exact direction. Elsewhere sine and cosine of tilt and dip are rounded to
 * 256 binary digits, which depths show from the 76th decimal on: of such scenes numbers are certain
 * to TP_WORLD_DIGITS at most. */

#ifndef TP_PROBLEM_WATER_SITE_H
#define TP_PROBLEM_WATER_SITE_H

#include "load/wetted.h"
#include "problem/base_joint.h"
#include "problem/world.h"

/* A block on its joint, in the frame of its problem, and the world that turned it; NULL: a table.
 */
typedef struct tp_water_site {
  const tp_scene *scene;
  const tp_polyline *ring;
  const tp_base_joint *joint;
  const tp_world *world;
} tp_water_site;

/* What presses on it as it goes left or right; numbers of so many digits are asked for. */
TP_MUST_USE tp_status tp_water_site_find(tp_wetted *wetted, const tp_water_site *site, bool left,
                                         long digits, tp_message *message);

#endif
