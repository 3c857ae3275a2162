/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Coordinates of a small displacement of the block in which closures are kept to their last digit.
 *
 * As the block slides, or comes to stand on its toe or between two points along which it slips as
 * it turns, its displacement grows without bound and the closures there do not: as differences of
 * large displacements they would be lost. So the coordinates are the displacements of two points
 * where it stands, each along the normal there, and the turn; where it stands in one place, that
 * point's along its normal and along its tangent, and the turn. */

#ifndef TP_QUASI_STATIC_FRAME_H
#define TP_QUASI_STATIC_FRAME_H

#include "quasi_static/model.h"

typedef struct tp_path_frame {
  tp_xy first, second; /* the points, which may be one */
  tp_xy normal, other; /* the directions of their displacements, not parallel */
} tp_path_frame;

typedef struct tp_path_pose {
  tp_path_frame frame;
  tp_three moved;
  tp_three since; /* the part of it in the step in hand: of a large displacement it would be lost as
                     a difference */
} tp_path_pose;

/* How the displacement of a point along a direction depends on the coordinates; and how a force at
 * the point along the direction acts on them. */
tp_three tp_path_along(const tp_path_frame *frame, tp_xy direction, tp_xy point);

double tp_three_product(const tp_three *a, const tp_three *b);

/* The same in another frame; exact in coordinates that both have. */
tp_path_pose tp_path_pose_in(const tp_path_pose *pose, const tp_path_frame *frame);

/* Moves on by a factor times a displacement in its frame. */
void tp_path_pose_add(tp_path_pose *pose, double factor, const tp_three *move);

/* Along x and y, and the turn, at a point. */
tp_path_frame tp_path_frame_at(tp_xy point);

/* Displacement of the centroid, and the turn. */
tp_three tp_path_pose_of_centroid(const tp_path_pose *pose);

/* The sum of the sizes of three components. */
double tp_three_size(const tp_three *x);

#endif
