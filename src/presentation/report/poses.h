/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All resting poses of a block, as text and as JSON. */

#ifndef TP_REPORT_POSES_H
#define TP_REPORT_POSES_H

#include "output/json.h"
#include "report/page.h"

/* A table, where the scene asks for them. */
void tp_page_add_poses(tp_page *page);

/* Rows that a page shows; JSON has them all. */
enum { TP_POSE_ROWS = 16 };

/* A share in per cent; at which tilt a pose begins to move in a case of the solution. */
const char *tp_pose_percent(char out[TP_NUMBER_SIZE], tp_bounded share);
const char *tp_pose_lets_go(char out[TP_NUMBER_SIZE + 4], const tp_resting_pose *pose,
                            size_t number_of_case);

/* Of all shifts those that end so. */
tp_bounded tp_poses_share(const tp_poses_result *poses, tp_settling_end end);

/* The pose that begins to move first in a case of the solution; as many as there are: none. */
size_t tp_poses_first_to_move(const tp_poses_result *poses, size_t number_of_case);

#endif
