/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, centroid and second moments of one outline by double arithmetic, where its bound is worth
 * telling; exactly, where not. */

#ifndef TP_BATCH_AREA_H
#define TP_BATCH_AREA_H

#include "batch/outline_scan.h"

/* The centroid from a point amid the outline, whose coordinates are doubles without an error. The
 * farther an outline is from the origin, the coarser are doubles there: only differences are as
 * certain as at the origin. */
typedef struct tp_area_centre {
  double origin_x, origin_y;
  tp_bounded x, y; /* from that point */
} tp_area_centre;

/* TP_UNDECIDED where doubles do not even tell the area from zero; TP_OUT_OF_MEMORY. */
TP_MUST_USE tp_status tp_area_filter(tp_area_moments *moments, tp_area_centre *centre,
                                     tp_workspace *workspace, tp_vertices vertices,
                                     const tp_scan_kernel *kernel, tp_message *message);

/* Exactly, rounded once. Bad input is told here. */
TP_MUST_USE tp_status tp_area_exact(tp_area_moments *moments, tp_vertices vertices,
                                    tp_message *message);

#endif
