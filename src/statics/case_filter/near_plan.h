/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The plan of a contact (contact_plan.h) found in doubles with bounds, for a block that shares it
 * with no other: the rays of the cone K of first-order motions and the modes on its faces. */

#ifndef TP_CASE_FILTER_NEAR_PLAN_H
#define TP_CASE_FILTER_NEAR_PLAN_H

#include "case_filter/shape.h"

/* From the plan's points, facets that all run up-dip from one end to the other, and the rows of the
 * shape: edges, rays and modes, and what the rays take to begin. False where doubles do not tell,
 * or there is no room. */
TP_MUST_USE bool tp_near_plan_find(tp_contact_plan *plan, tp_case_shape *shape);

/* The same of some of the points of a contact, from site 0 to the last one, whose motions are those
 * of all: each two that follow one another in the ring have to share one. */
TP_MUST_USE bool tp_near_plan_find_ring(tp_contact_plan *plan, tp_case_shape *shape,
                                        const int *ring, int ring_count, long last_site);

#endif
