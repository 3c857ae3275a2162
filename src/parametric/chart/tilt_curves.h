/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the charts of a tilt test share. */

#ifndef TP_CHART_TILT_CURVES_H
#define TP_CHART_TILT_CURVES_H

#include "chart/chart.h"

/* "left", "right". */
const char *tp_chart_towards(tp_direction towards);

/* A range that nothing is in yet; with a value more; with a margin for drawing, and never without
 * width. */
tp_chart_range tp_chart_range_empty(void);
void tp_chart_range_take(tp_chart_range *range, double value);
tp_chart_range tp_chart_range_drawn(tp_chart_range range);

/* A line of the axis at zero, where it is in the range. */
void tp_chart_add_level(tp_chart *chart, tp_chart_range x, tp_chart_range y, double level);

#endif
