/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as a part of a report in JSON. */

#ifndef TP_REPORT_SOLUTION_JSON_H
#define TP_REPORT_SOLUTION_JSON_H

#include "output/json.h"

/* Members of the report's object: title, level, notes, and a case for each direction of tilt. */
void tp_json_solution(tp_json *json, const tp_solution *solution, tp_pivots_listed listed);

#endif
