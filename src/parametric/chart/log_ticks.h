/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Labels within the decades of a logarithmic axis, as a command of gnuplot: 1, 2, 5, and more of
 * them where the axis is short. */

#ifndef TP_CHART_LOG_TICKS_H
#define TP_CHART_LOG_TICKS_H

#include "chart/chart.h"
#include "output/text.h"

/* Of the axis `name`, x or y. */
void tp_script_log_ticks(tp_text *text, const tp_panel_axis *axis, char name);

#endif
