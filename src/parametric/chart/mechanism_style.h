/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How maps of mechanisms tell their regions and borders apart. */

#ifndef TP_CHART_MECHANISM_STYLE_H
#define TP_CHART_MECHANISM_STYLE_H

#include "chart/chart.h"

static const tp_chart_style tp_region_slides = {TP_MARK_REGION, TP_COLOUR_SKY_BLUE, TP_DASH_SOLID,
                                                0};
static const tp_chart_style tp_region_topples = {TP_MARK_REGION, TP_COLOUR_ORANGE, TP_DASH_SOLID,
                                                 0};
static const tp_chart_style tp_region_both = {TP_MARK_REGION, TP_COLOUR_PURPLE, TP_DASH_SOLID, 0};
static const tp_chart_style tp_region_interlocked = {TP_MARK_REGION, TP_COLOUR_GREEN, TP_DASH_SOLID,
                                                     0};
static const tp_chart_style tp_region_history = {TP_MARK_REGION, TP_COLOUR_YELLOW, TP_DASH_SOLID,
                                                 0};
static const tp_chart_style tp_region_other = {TP_MARK_REGION, TP_COLOUR_GREY, TP_DASH_SOLID, 0};

static const tp_chart_style tp_line_slides = {TP_MARK_LINE, TP_COLOUR_BLUE, TP_DASH_DASHED, 0};
static const tp_chart_style tp_line_topples = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_SOLID,
                                               0};
static const tp_chart_style tp_line_both = {TP_MARK_LINE, TP_COLOUR_PURPLE, TP_DASH_DASH_DOT, 0};
static const tp_chart_style tp_line_onset = {TP_MARK_LINE, TP_COLOUR_GREEN, TP_DASH_SOLID, 0};
static const tp_chart_style tp_line_dynamic = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_LONG, 0.7};
static const tp_chart_style tp_line_dynamic_valley = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DOTTED,
                                                      0.7};
static const tp_chart_style tp_line_moments = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DASH_DOT,
                                               0.7};
static const tp_chart_style tp_line_sliding = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DOTTED, 0.9};
static const tp_chart_style tp_line_contour = {TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_SOLID, 0.6};
static const tp_chart_style tp_line_stands = {TP_MARK_LINE, TP_COLOUR_GREEN, TP_DASH_DASHED, 0.8};
static const tp_chart_style tp_line_border = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0.7};

#endif
