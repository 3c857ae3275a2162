/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chart as commands for gnuplot, which plot to its standard output. Every text stands in single
 * quotes, in which gnuplot executes nothing; a user's is taken as it is, without markup. */

#ifndef TP_CHART_SCRIPT_H
#define TP_CHART_SCRIPT_H

#include "chart/chart.h"

TP_MUST_USE tp_status tp_chart_script(char **text, const tp_chart *chart, tp_chart_format format);

#endif
