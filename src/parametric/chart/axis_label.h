/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What an axis of a map says of a number of the scene: quantity, symbol and unit. */

#ifndef TP_CHART_AXIS_LABEL_H
#define TP_CHART_AXIS_LABEL_H

#include "scene/scene.h"

/* The label, in gnuplot's markup where *plain is false. A parameter has the quantity and the unit
 * of the one place of the scene that is it alone; one that stands in several has a unit where all
 * are lengths. A coordinate is called by its key. */
void tp_axis_label(char *label, size_t size, bool *plain, const char *key, const tp_scene *scene);

#endif
