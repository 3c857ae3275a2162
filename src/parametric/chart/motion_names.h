/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motions that can begin at a tilt, in words and in colour. */

#ifndef TP_CHART_MOTION_NAMES_H
#define TP_CHART_MOTION_NAMES_H

#include "chart/chart.h"

enum { TP_MOTIONS_NAME_SIZE = 80, TP_MOTIONS_BORDER_SIZE = 2 * TP_MOTIONS_NAME_SIZE + 4 };

/* "topples", "slides, or topples"; "stands" where none can begin: a bit for each, as in
 * tp_motion_range. */
void tp_motions_name(char text[TP_MOTIONS_NAME_SIZE], unsigned motions);
/* "topples | slides and topples" */
void tp_motions_border_name(char text[TP_MOTIONS_BORDER_SIZE], unsigned one, unsigned other);
tp_chart_style tp_motions_region(unsigned motions);

#endif
