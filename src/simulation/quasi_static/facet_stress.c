/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Forces at the ends of a facet and their derivatives in closed form, closed along all or part of
 * its length. */

#include "quasi_static/facet_stress.h"

/* Closed all along. */
static tp_facet_stress all_closed(double length, double from, double to) {
  return (tp_facet_stress){.force_from = length * (from / 3 + to / 6),
                           .force_to = length * (from / 6 + to / 3),
                           .stiffness_from = length / 3,
                           .stiffness_between = length / 6,
                           .stiffness_to = length / 3,
                           .closed = 1};
}

/* Closed along a share c of the length at the end with closure `near` > 0; that of the far end is
 * below 0. With x the distance from the near end over the length, the stress is near (1 - x / c):
 * far force = length int_0^c x near (1 - x / c) dx = length near c^2 / 6, and so on. */
static tp_facet_stress part_closed(double length, double near, double far) {
  const double span = near - far, c = near / span;
  const double far_force = length * near * c * c / 6, cube = c * c * c / 3;
  return (tp_facet_stress){.force_from = length * near * c / 2 - far_force,
                           .force_to = far_force,
                           .stiffness_from = length * (c - c * c + cube),
                           .stiffness_between = length * (c * c / 2 - cube),
                           .stiffness_to = length * cube,
                           .closed = c,
                           .closed_by_from = -far / span / span,
                           .closed_by_to = near / span / span};
}

static tp_facet_stress mirrored(tp_facet_stress s) {
  return (tp_facet_stress){.force_from = s.force_to,
                           .force_to = s.force_from,
                           .stiffness_from = s.stiffness_to,
                           .stiffness_between = s.stiffness_between,
                           .stiffness_to = s.stiffness_from,
                           .closed = s.closed,
                           .closed_by_from = s.closed_by_to,
                           .closed_by_to = s.closed_by_from};
}

tp_facet_stress tp_facet_stress_of(double length, bool in_a_point, double from, double to) {
  if (in_a_point) {
    if (from < 0) return (tp_facet_stress){0};
    return (tp_facet_stress){.force_from = length * from, .stiffness_from = length, .closed = 1};
  }
  if (from >= 0 && to >= 0) return all_closed(length, from, to);
  if (from > 0) return part_closed(length, from, to);
  if (to > 0) return mirrored(part_closed(length, to, from));
  return (tp_facet_stress){0};
}
