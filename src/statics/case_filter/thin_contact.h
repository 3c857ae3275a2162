/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which points of a contact with many facets matter, as doubles have it: those that the cone of
 * first-order motions has its faces on, those that bear the loads at the limits of what holds, and
 * the facets that may slide. Proposals all of them: that the others do not matter is proven of each
 * motion (contact_rest.h). */

#ifndef TP_CASE_FILTER_THIN_CONTACT_H
#define TP_CASE_FILTER_THIN_CONTACT_H

#include "case_filter/contact_plan.h"
#include "case_filter/contact_rest.h"

typedef struct tp_thin_contact {
  int count;
  int points[TP_PLAN_POINTS]; /* of all, the ends of facet k being 2 k and 2 k + 1 */
  int ring_count;
  int ring[TP_PLAN_POINTS]; /* of those: each two that follow share a motion */
  int facet_count;
  int facets[2]; /* of all: steepest down-dip of the centroid, and of all */
} tp_thin_contact;

/* Of all points as if none were left out, and a point that has to be among them; false where there
 * is no room, or a facet lies too near upright. */
TP_MUST_USE bool tp_thin_contact_find(tp_thin_contact *thin, const tp_contact_rest *all,
                                      double friction, int point, bool first_is_down_dip);

#endif
