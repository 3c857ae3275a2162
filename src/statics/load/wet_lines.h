/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines with a pressure linear along each, which pushes to their left: what water presses on. */

#ifndef TP_LOAD_WET_LINES_H
#define TP_LOAD_WET_LINES_H

#include "scene/scene.h"

typedef struct tp_wet_lines {
  long count, capacity;
  tp_line_load *items;
} tp_wet_lines;

/* One more, all of whose numbers are zero; NULL when memory is exhausted. */
tp_line_load *tp_wet_lines_next(tp_wet_lines *lines);
void tp_wet_lines_clear(tp_wet_lines *lines);

/* Force and moment about the origin, for a thickness of 1 m, in kN/m and kN; mirrored where the
 * block is. */
void tp_wet_lines_sum(fmpq_t fx, fmpq_t fy, fmpq_t moment, const tp_wet_lines *lines,
                      const fmpq_t metres_per_unit, bool mirrored);

#endif
