/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit under cohesion and bonds, in doubles with bounds: what the base bears is a
 * convex set, no cone (docs/mechanics.md section 6). */

#ifndef TP_CASE_FILTER_STRONG_LIMIT_H
#define TP_CASE_FILTER_STRONG_LIMIT_H

#include "case_filter/edge_faces.h"

/* The tangent and the mechanism at which v . b falls below what cohesion and bonds bear against a
 * mechanism, where forces hold. False where doubles do not tell. */
TP_MUST_USE bool tp_strong_limit_find(tp_near *tangent, tp_mechanism *mechanism,
                                      const tp_edge_set *set);

/* Is b borne by edges and `scale` times the capacities? True where that is proven. */
bool tp_strong_limit_bears(const tp_edge_set *set, const tp_near b[3], tp_near scale);

#endif
