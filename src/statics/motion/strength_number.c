/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which modes share what cohesion and bonds do (strength.h), so that their planes end at one tilt.
 */

#include "motion/strength.h"

bool tp_strength_bonds_alone(const tp_motion_question *q) {
  const tp_cones *strong = q->strong;
  for (long k = 0; k < strong->capacity_count; k++) {
    if (!arb_is_zero(strong->capacities[k].shear)) return false;
  }
  return true;
}

/* A slide with bonds is pulled otherwise than a turn that the line's bonds hold. */
static bool is_alone(const tp_motion_question *q, const tp_twists *twists, const tp_mode *mode) {
  const tp_cones *strong = q->strong;
  if (mode->ray_count == 0 || mode->edge_count == 0) return true;
  if (!tp_mode_slides(mode, twists)) return false;
  for (long k = 0; k < strong->capacity_count; k++) {
    if (!arb_is_zero(strong->capacities[k].pull)) return true;
  }
  return false;
}

/* The line goes by its first point. A slide on more lines than one is none's alone. */
static tp_motion_outcome find_least(long *least, const tp_normals *n, long first, bool slides) {
  const long own = n->family_of[first];
  long family = own;
  while (slides && family > 0 && n->families[family - 1].axis == n->families[own].axis) family--;
  *least = first;
  for (; family < n->family_count && (slides || family == own); family++) {
    if (n->families[family].axis != n->families[own].axis) break;
    long ends[2];
    tp_normals_of_family(ends, n, family);
    for (long k = ends[0]; k < ends[1] && *least >= 0; k++) {
      const long point = n->order[k];
      const int shared = point == first ? 1 : tp_normals_share_line(n, first, point);
      if (shared == TP_OPEN_SIGN) return TP_MOTION_OPEN;
      if (shared == 1 && point < *least) *least = point;
      if (shared == 0 && slides) *least = -1;
    }
  }
  return TP_MOTION_PROVEN;
}

tp_motion_outcome tp_strength_number(long *number, const tp_motion_question *q, const tp_normals *n,
                                     const tp_twists *twists, const tp_mode *mode) {
  *number = 0;
  if (tp_strength_bonds_alone(q)) {
    *number = mode->ray_count == 0 || !tp_mode_slides(mode, twists) ? 1 : 0;
    return TP_MOTION_PROVEN;
  }
  if (is_alone(q, twists, mode)) return TP_MOTION_PROVEN;
  const long first = mode->edges[0].point;
  for (long k = 1; k < mode->edge_count; k++) {
    const int shared = tp_normals_share_line(n, first, mode->edges[k].point);
    if (shared == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (shared == 0) return TP_MOTION_PROVEN;
  }
  long least = -1;
  const tp_motion_outcome done = find_least(&least, n, first, tp_mode_slides(mode, twists));
  *number = least + 1;
  return done;
}
