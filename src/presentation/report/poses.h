/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All resting poses of a block, as text and as JSON. */

#ifndef TP_REPORT_POSES_H
#define TP_REPORT_POSES_H

#include "output/json.h"
#include "report/page.h"

/* A table, where the scene asks for them. */
void tp_page_add_poses(tp_page *page);

/* The pose that begins to move first in a case of the solution; as many as there are: none. */
size_t tp_poses_first_to_move(const tp_poses_result *poses, size_t number_of_case);

#endif
