/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What results of a solid have to satisfy whatever its shape, checked on the results themselves.
 *
 * The hull is proven (solid/hull.h), and decisions are exact; this would show a fault in what is
 * computed from them. Seen from the centroid, facets of a convex body fill all directions once, so
 * that shares are between 0 and 1 and their sum is 1. A solid that stands has its foot within its
 * support, so that each tilt about an edge is above 0 and below 90 degrees. */

#ifndef TP_SOLID_TILT_RESULTS_CHECK_H
#define TP_SOLID_TILT_RESULTS_CHECK_H

#include "topple.h"

/* TP_DEPENDENCY_FAILED where poses or bands contradict that by more than their bounds. */
TP_MUST_USE tp_status tp_solid_results_check(const tp_solid *solid, tp_message *message);

#endif
