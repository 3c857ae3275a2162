/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All resting poses of a block, as text and as JSON. */

#ifndef TP_REPORT_POSES_H
#define TP_REPORT_POSES_H

#include "output/json.h"
#include "report/page.h"

/* A table, where the scene asks for them. */
void tp_page_add_poses(tp_page *page);

/* The key `poses` of a case. */
void tp_json_poses(tp_json *json, const tp_poses_result *poses, size_t number_of_case);

#endif
