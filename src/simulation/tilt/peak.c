/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The turn at which the centroid of a block is over its outermost contact is its balance angle:
 * beyond it gravity overturns the block, unless the shaking brings it back. A block on level ground
 * has atan(b / h), with b and h half its width and height (Housner 1963). On a tilted table the
 * turn is less to the side that goes down. With loads besides the weight, and of rounded corners,
 * on which a block rolls, there is no such single angle here. */

#include "tilt/peak.h"

#include "tilt/trial.h"

#include <math.h>

static bool is_straight(const tp_rigid_body *body) {
  for (long k = 0; k < body->outline.count; k++) {
    if (body->outline.edges[k].arc) return false;
  }
  return true;
}

/* Upwards, in the frame of the base. */
static tp_xy up_of(const tp_rigid_body *body, double angle) {
  const double side = body->towards == TP_TOWARDS_LEFT ? 1 : -1;
  return (tp_xy){side * sin(angle), cos(angle)};
}

/* The turn about the outermost contact on the left, counter-clockwise, or on the right, clockwise:
 * above 0. False: none is known. */
static bool find_balance(double *turn, const tp_rigid_body *body, double angle, bool left) {
  if (body->loads.given || body->closed_count == 0 || !is_straight(body)) return false;
  tp_xy outermost = body->closed[0].at;
  for (long k = 1; k < body->closed_count; k++) {
    const tp_xy at = body->closed[k].at;
    if (left ? at.x < outermost.x : at.x > outermost.x) outermost = at;
  }
  /* from the contact to the centroid, which is the origin, and on to the vertical */
  const tp_xy arm = {-outermost.x, -outermost.y}, up = up_of(body, angle);
  const double clockwise = atan2(arm.y * up.x - arm.x * up.y, arm.x * up.x + arm.y * up.y);
  *turn = left ? -clockwise : clockwise;
  return *turn > 0;
}

void tp_tilting_peak(tp_tilting *tilting, const tp_turn_range *turns, double angle) {
  tp_tilt_case *own = tilting->own;
  double balance[2] = {0, 0}; /* clockwise, counter-clockwise */
  const double turned[2] = {-turns->least, turns->most};
  const bool known = find_balance(balance, tilting->body, angle, false) &&
                     find_balance(balance + 1, tilting->body, angle, true);
  const double share[2] = {known ? turned[0] / balance[0] : turned[0],
                           known ? turned[1] / balance[1] : turned[1]};
  const int way = share[1] >= share[0] ? 1 : 0;
  own->has_peak_turn = turned[way] > 0;
  if (!own->has_peak_turn) return;
  own->peak_turn_deg = tp_tilt_degrees(way == 1 ? turns->most : turns->least);
  own->peak_turn_s = way == 1 ? turns->most_s : turns->least_s;
  own->has_balance_turn = known;
  if (!known) return;
  own->balance_turn_deg = tp_tilt_degrees(balance[way]);
  own->peak_over_balance = share[way];
}
