/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area and first moments of a section as sums over its triangles: the way of the textbooks, beside
 * which the boundary sums are measured. */

#ifndef TP_BLOCK_TRIANGLE_SUMS_H
#define TP_BLOCK_TRIANGLE_SUMS_H

#include "block/moments.h"
#include "geom/geom.h"

/* A2, X6 and Y6 of `moments` at one rung, each ring by its weight; the second moments are left as
 * they are. At TP_LEVEL_DOUBLE and TP_LEVEL_COMPENSATED plain doubles with a proven bound. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_triangle_sums(tp_moments *moments, const tp_geom_triangulation *triangulation,
                                  const tp_section *section, const tp_lattice *lattice,
                                  tp_rung rung);

#endif
