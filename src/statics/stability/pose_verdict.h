/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the block stand in a resting pose? The scene is solved with it there. */

#ifndef TP_STABILITY_POSE_VERDICT_H
#define TP_STABILITY_POSE_VERDICT_H

#include "scene/scene.h"
#include "topple.h"

/* Fill in the verdicts, of a scene with the block in its pose. One that cannot be solved there says
 * so, and is no failure. */
TP_MUST_USE tp_status tp_pose_solve(tp_resting_pose *pose, const tp_scene *placed,
                                    const tp_solve_options *options, tp_message *message);

/* Mark the pose that begins to move first as the table is tilted, for each of so many cases. */
void tp_poses_least(tp_poses_result *poses, size_t case_count);

#endif
