/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tilts about edges as quotients of arms and heights, of which the least is taken. */

#include "solid/tilting.h"

#include "number/near_angle.h"

tp_near tp_tilt_tangent(const tp_centre *centre, const tp_rest_plane *plane, tp_support_edge edge,
                        tp_near height) {
  tp_near outward[3];
  tp_rest_plane_outward(outward, centre->surface, plane, edge.from, edge.to);
  const tp_near arm = tp_centre_arm(centre, plane, edge.from, edge.to, tp_solid_accuracy);
  const tp_near top = tp_near_mul(arm, tp_near_norm(plane->near_up));
  return tp_near_div(top, tp_near_mul(height, tp_near_norm(outward)));
}

void tp_tilt_least(tp_solid_tilt *least, const tp_centre *centre, const tp_rest_plane *plane,
                   const tp_map_frame *frame, const tp_support_edge *edges, long count,
                   bool *told) {
  const tp_near height = tp_centre_height(centre, plane, tp_solid_accuracy);
  tp_near tangent = {0, 0}, bound = tangent;
  long found = 0;
  for (long k = 0; k < count; k++) {
    const tp_near own = tp_tilt_tangent(centre, plane, edges[k], height);
    bound = k == 0 ? own : tp_near_lesser(bound, own);
    if (k > 0 && tp_near_sign(tp_near_sub(own, tangent)) >= 0)
      continue; /* of equal ones the first */
    tangent = own;
    found = k;
  }
  const tp_support_edge edge = edges[found];
  tp_near outward[3], east, north;
  tp_rest_plane_outward(outward, centre->surface, plane, edge.from, edge.to);
  tp_map_components(&east, &north, frame, outward);
  const tp_near angle = tp_near_arctangent(bound);
  least->tilt_deg = tp_near_bounded(angle);
  least->azimuth_deg = tp_azimuth_of(east, north);
  for (int k = 0; k < 3; k++) {
    least->edge_from[k] = tp_surface_given(centre->surface, edge.from, k);
    least->edge_to[k] = tp_surface_given(centre->surface, edge.to, k);
  }
  if (!tp_tilt_is_told(angle)) *told = false;
}

/* Of one more arm, after those of before. */
static int next_side(int before, tp_near arm) {
  const int side = tp_near_sign(arm);
  if (side < 0) return -1;
  if (side > 0 || before == 2) return before;
  return tp_near_is_zero(arm) ? 0 : 2;
}

int tp_arms_side(const tp_near *arms, long count) {
  int side = 1;
  for (long k = 0; k < count && side >= 0; k++) side = next_side(side, arms[k]);
  return side;
}

int tp_foot_side(const tp_centre *centre, const tp_rest_plane *plane, const tp_support_edge *edges,
                 long count) {
  int side = 1;
  for (long k = 0; k < count && side >= 0; k++) {
    side = next_side(side, tp_centre_arm(centre, plane, edges[k].from, edges[k].to, 0));
  }
  return side;
}
