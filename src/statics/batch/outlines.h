/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many outlines in one array, as the calls of topple_blocks.h are given them. */

#ifndef TP_BATCH_OUTLINES_H
#define TP_BATCH_OUTLINES_H

#include "common/message.h"

/* One of them: x0, y0, x1, y1, ... */
typedef struct tp_vertices {
  const double *xy;
  size_t count;
} tp_vertices;

/* Without the first point repeated at its end, where there are three more. */
tp_vertices tp_vertices_open(const double *xy, size_t count);

/* The k-th outline. */
tp_vertices tp_outlines_at(const tp_outlines *outlines, size_t k);

/* Refuse outlines that no call can go through. */
TP_MUST_USE tp_status tp_outlines_check(const tp_outlines *outlines, const char *call,
                                        tp_message *message);

#endif
