/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "compare.h"

#include <math.h>

static bool is_open(const tp_onset *onset) {
  return onset->kind == TP_ONSET_UNDECIDED;
}

static bool may_be_named(const tp_onset *one, const tp_onset *other) {
  return one->mechanism == other->mechanism ||
         (one->tie && other->tie && one->mechanism == other->tied_with);
}

static void compare_windows(const comparison *c, const tp_window *one, const tp_window *other) {
  compare_need(c, one->from_below == other->from_below && one->to_above == other->to_above,
               "ends of a window of motion");
  if (!one->from_below && c->why[0] == '\0') {
    compare_angle(c, one->from_deg, other->from_deg, "lower end of a window of motion");
  }
  if (!one->to_above && c->why[0] == '\0') {
    compare_angle(c, one->to_deg, other->to_deg, "upper end of a window of motion");
  }
}

static void compare_motions(const comparison *c, const tp_onset *one, const tp_onset *other) {
  if (!one->has_motions || !other->has_motions) return;
  compare_need(c, one->motion_count == other->motion_count, "number of motions");
  compare_need(c, one->paradox == other->paradox, "paradox");
  if (c->why[0] != '\0' || one->motion_count != 1) return; /* their order is free */
  const tp_motion *a = one->motions, *b = other->motions;
  compare_need(c, a->mechanism == b->mechanism, "mechanism of a motion");
  compare_need(c, a->accelerations_fixed == b->accelerations_fixed, "fixed accelerations");
  if (!a->accelerations_fixed) return;
  tp_bounded turned = b->angular_g_per_m;
  if (c->r->mirrored) turned.value = -turned.value;
  compare_number(c, turned, a->angular_g_per_m, 1, "angular acceleration"); /* over the length */
}

/* Is it told whether the onset lies below the limit, whatever the bits? */
static bool lies_clear(const tp_case *one) {
  static const double clear = 1e-9;
  if (one->limit.kind == TP_LIMIT_UNDECIDED) return false;
  const bool angles = one->limit.kind == TP_LIMIT_AT_ANGLE && one->onset.kind == TP_ONSET_AT_ANGLE;
  return !angles ||
         fabs(one->limit.critical_angle_deg.value - one->onset.critical_angle_deg.value) > clear;
}

void compare_onsets(const comparison *c, const tp_case *one, const tp_case *other) {
  const tp_onset *a = &one->onset, *b = &other->onset;
  if (is_open(a) || is_open(b)) return;
  compare_need(c, a->kind == b->kind, "onset of motion");
  compare_need(c, a->window_count == b->window_count, "number of windows of motion");
  for (size_t k = 0; k < a->window_count && c->why[0] == '\0'; k++) {
    compare_windows(c, a->windows + k, b->windows + k);
  }
  if (c->why[0] != '\0') return;
  const bool told = lies_clear(one) && lies_clear(other);
  compare_need(c, !told || a->below_limit == b->below_limit, "onset below the limit");
  if (a->kind != TP_ONSET_AT_ANGLE) return;
  compare_angle(c, a->critical_angle_deg, b->critical_angle_deg, "angle of the onset");
  compare_need(c, may_be_named(a, b), "mechanism of the onset");
  compare_need(c, a->has_centre == b->has_centre || a->tie, "centre of the onset");
  if (a->has_centre && b->has_centre && !a->tie) {
    compare_point(c, (tp_bounded[]){a->centre_x_m, a->centre_y_m},
                  (tp_bounded[]){b->centre_x_m, b->centre_y_m}, "centre of the onset");
  }
  compare_motions(c, a, b);
}
