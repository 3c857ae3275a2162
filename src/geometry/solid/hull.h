/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The convex hull of the points of a surface, proven.
 *
 * CGAL proposes a hull, and solid/hull_proof.h proves it by exact signs before anything uses it. A
 * proposal that fails is followed by one of exact arithmetic. Where that fails too, the call ends
 * with an error: no hull that is not proven is ever returned. */

#ifndef TP_SOLID_HULL_H
#define TP_SOLID_HULL_H

#include "solid/hull_proof.h"

/* Bad input where all points are in one plane; TP_DEPENDENCY_FAILED where no proposal is proven. On
 * failure the hull is empty. */
TP_MUST_USE tp_status tp_hull_find(tp_hull *hull, const tp_surface *surface, tp_message *message);

/* What proposes a hull: tp_geom_propose_hull. A test damages what that returns. */
typedef tp_geom_status (*tp_hull_search)(tp_geom_hull *hull, const tp_geom_points *points,
                                         bool exact);

/* tp_hull_find with another search. */
TP_MUST_USE tp_status tp_hull_find_by(tp_hull *hull, const tp_surface *surface,
                                      tp_hull_search search, tp_message *message);

#endif
