/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motions that can begin, in a map along one scalar. */

#ifndef TP_CHART_MAP_STRIPS_H
#define TP_CHART_MAP_STRIPS_H

#include "chart/map_line.h"

/* Beyond the limit the motions that begin there, as regions; everywhere the borders between one
 * motion and another. Looks without strips have a region of the limit's mechanism. */
void tp_line_add_regions(const tp_map_line *line);
void tp_line_add_motions(const tp_map_line *line);

#endif
