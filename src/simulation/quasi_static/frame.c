/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conversion of directions and displacements between frames of two points with normals. */

#include "quasi_static/frame.h"

#include <math.h>

/* About the first point P a displacement along d is d . u + ((q - P) x d) turn. With d = a n + b m
 * of the two directions it is a times the displacement of P along n, b times that of the second
 * point along m, and for the turn what is left of the moment. Of the two points themselves a and b
 * come out as 1 and 0, and the rest as 0, without rounding. */
tp_three tp_path_along(const tp_path_frame *frame, tp_xy direction, tp_xy point) {
  const double span = tp_xy_cross(frame->normal, frame->other);
  const double first = tp_xy_cross(direction, frame->other) / span;
  const double second = tp_xy_cross(frame->normal, direction) / span;
  const double moment = tp_xy_cross(tp_xy_minus(point, frame->first), direction);
  const double arm = tp_xy_cross(tp_xy_minus(frame->second, frame->first), frame->other);
  return (tp_three){{first, second, moment - second * arm}};
}

double tp_three_product(const tp_three *a, const tp_three *b) {
  return a->of[0] * b->of[0] + a->of[1] * b->of[1] + a->of[2] * b->of[2];
}

double tp_three_size(const tp_three *x) {
  return fabs(x->of[0]) + fabs(x->of[1]) + fabs(x->of[2]);
}

tp_path_pose tp_path_pose_in(const tp_path_pose *pose, const tp_path_frame *frame) {
  const tp_three first = tp_path_along(&pose->frame, frame->normal, frame->first);
  const tp_three second = tp_path_along(&pose->frame, frame->other, frame->second);
  return (tp_path_pose){.frame = *frame,
                        .moved = {{tp_three_product(&first, &pose->moved),
                                   tp_three_product(&second, &pose->moved), pose->moved.of[2]}}};
}

tp_path_frame tp_path_frame_at(tp_xy point) {
  return (tp_path_frame){.first = point, .second = point, .normal = {1, 0}, .other = {0, 1}};
}

void tp_path_pose_add(tp_path_pose *pose, double factor, const tp_three *move) {
  for (int k = 0; k < 3; k++) {
    pose->moved.of[k] += factor * move->of[k];
    pose->since.of[k] += factor * move->of[k];
  }
}

tp_three tp_path_pose_of_centroid(const tp_path_pose *pose) {
  const tp_path_frame at_centroid = tp_path_frame_at((tp_xy){0, 0});
  return tp_path_pose_in(pose, &at_centroid).moved;
}
