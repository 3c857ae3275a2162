/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a point lies to the outline of a block, in exact rationals. */

#ifndef TP_LOAD_OUTLINE_H
#define TP_LOAD_OUTLINE_H

#include "plane/polyline.h"

/* Does a point lie on the edge from the k-th vertex of the outline on, or in or on all of it? */
bool tp_loads_on_edge(const tp_polyline *ring, long k, const fmpq *x, const fmpq *y);
bool tp_loads_in_outline(const tp_polyline *ring, const fmpq *x, const fmpq *y);

#endif
