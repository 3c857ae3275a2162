/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Can the toe alone hold the block at its critical angle? Up to phi_b + i of the steepest facet
 * there; where facets have frictions of their own, up to the largest phi_b + i of them. */

#include "evaluation/sliding_facet.h"
#include "evaluation/stages.h"

/* The larger of two angles; where that is open, what encloses it. */
static void take_larger(tp_direction_ball *limit, tp_direction_ball *other, long bits) {
  if (arb_gt(other->degrees, limit->degrees)) {
    const tp_direction_ball held = *limit;
    *limit = *other;
    *other = held;
  } else if (!arb_le(other->degrees, limit->degrees)) {
    arb_max(limit->degrees, limit->degrees, other->degrees, bits);
    limit->exact_direction = false;
    limit->adds = NULL;
  }
}

/* With the friction at a tilt; `steepest` is that of the facets at the toe. */
static void find_limit(tp_direction_ball *limit, const tp_evaluation *e,
                       const tp_sliding_facet *steepest, tp_direction towards, tp_outline_point toe,
                       const arb_t tilt) {
  const tp_contact *contact = &e->problem->contact;
  tp_sliding_add_friction_at(e, steepest, tilt, limit);
  for (long k = 0; k < contact->facet_count && e->problem->friction.count > 0; k++) {
    if (!tp_facet_ends_in(&e->problem->lattice, contact->facets + k, toe)) continue;
    tp_sliding_facet own;
    tp_direction_ball other;
    tp_sliding_facet_init(&own);
    tp_direction_ball_init(&other);
    tp_sliding_facet_consider(e, k, towards, &own);
    if (own.facet >= 0) {
      tp_sliding_add_friction_at(e, &own, tilt, &other);
      take_larger(limit, &other, e->rung.bits);
    }
    tp_direction_ball_clear(&other);
    tp_sliding_facet_clear(&own);
  }
}

void tp_evaluate_toe(const tp_evaluation *e, tp_case *result, const tp_direction_ball *toppling,
                     tp_certainty *certainty) {
  const tp_contact *contact = &e->problem->contact;
  result->toe = (tp_toe){0};
  if (!result->has_toppling_pivot || e->loaded != NULL)
    return; /* the reaction is not the weight's */
  const tp_outline_point toe =
      tp_contact_on_outline(contact->points + result->pivots[result->toppling_pivot].index);
  tp_sliding_facet best;
  tp_sliding_facet_init(&best);
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *facet = contact->facets + k;
    if (tp_facet_ends_in(&e->problem->lattice, facet, toe)) {
      tp_sliding_facet_consider(e, k, result->towards, &best);
    }
  }
  if (best.facet >= 0 || best.blocked) {
    tp_direction_ball limit;
    tp_direction_ball_init(&limit);
    result->toe.known = true;
    result->toe.upright = result->toe.holds = best.blocked;
    if (!best.blocked) {
      find_limit(&limit, e, &best, result->towards, toe, toppling->degrees);
      result->toe.limit_angle_deg = tp_result(e, limit.degrees, certainty);
      result->toe.holds = tp_direction_ball_compare(e, toppling, &limit, certainty) <= 0;
    }
    tp_direction_ball_clear(&limit);
  }
  tp_sliding_facet_clear(&best);
}
