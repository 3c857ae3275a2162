/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of regions of a map along one scalar, where there is room for them. */

#ifndef TP_CHART_MAP_NAMES_H
#define TP_CHART_MAP_NAMES_H

#include "chart/map_line.h"

/* Where the name of regions has most room. */
typedef struct tp_line_name {
  bool found;
  double worth, scalar, tilt;
} tp_line_name;

/* `best` or a better point in the region; of a new one `found` is false. */
void tp_line_find_name(tp_line_name *best, const tp_map_line *line, const char *name,
                       const tp_line_region *region);
/* False where there is none. */
bool tp_line_add_name(const tp_map_line *line, const char *name, const tp_line_name *at);

#endif
