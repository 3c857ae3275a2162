/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outlines in JSON, for programs that draw them. */

#ifndef TP_REPORT_PATH_JSON_H
#define TP_REPORT_PATH_JSON_H

#include "output/json.h"
#include "shape/shape.h"

/* Path data of SVG with y upwards, in metres. */
void tp_json_path(tp_json *json, const char *key, const tp_chain *chain, double unit_m);

#endif
