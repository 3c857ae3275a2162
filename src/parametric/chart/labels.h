/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The side of a point on which its label strikes the fewest curves. */

#ifndef TP_CHART_LABELS_H
#define TP_CHART_LABELS_H

#include "chart/chart.h"

/* On which side of a point of the last panel the fewest curves and points, of those added so far,
 * strike the label. */
tp_label_side tp_chart_free_side(const tp_chart *chart, double x, double y, const char *text);

#endif
