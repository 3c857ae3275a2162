/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, centroid and second moments of one outline by double arithmetic, where its bound is worth
 * telling; exactly, where not. */

#ifndef TP_BATCH_AREA_H
#define TP_BATCH_AREA_H

#include "batch/outline_scan.h"

/* TP_UNDECIDED where doubles do not even tell the area from zero; TP_OUT_OF_MEMORY. */
TP_MUST_USE tp_status tp_area_filter(tp_area_moments *moments, tp_workspace *workspace,
                                     tp_vertices vertices, const tp_scan_kernel *kernel,
                                     tp_message *message);

/* Exactly, rounded once. Bad input is told here. */
TP_MUST_USE tp_status tp_area_exact(tp_area_moments *moments, tp_vertices vertices,
                                    tp_message *message);

#endif
