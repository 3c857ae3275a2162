/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What of a section lies above the plane that cuts the solid. */

#ifndef TP_REPORT_SECTION_ABOVE_H
#define TP_REPORT_SECTION_ABOVE_H

#include "scene/scene.h"

typedef struct tp_section_above {
  long count; /* of its corners, counter-clockwise; 0: nothing lies above */
  double *x, *y;
} tp_section_above;

/* The largest piece of an outline above y = level; corners on that line lie on it to the last
 * digit. False when memory is exhausted. To be cleared. */
bool tp_section_above_init(tp_section_above *above, const tp_polyline *outline, double level);
void tp_section_above_clear(tp_section_above *above);

#endif
