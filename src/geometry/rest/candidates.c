/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* List of pairs with an interval for the time of their contact; pairs that begin after the earliest
 * certain contact are dropped, and a budget bounds their number. */

#include "rest/candidates.h"

#include "common/budget.h"
#include "common/grow.h"

#include <math.h>
#include <stdlib.h>

void tp_candidates_clear(tp_candidates *candidates) {
  free(candidates->items);
  *candidates = (tp_candidates){.best = INFINITY};
}

bool tp_candidates_note(tp_candidates *candidates, tp_candidate candidate) {
  if (candidate.low > candidates->best) return true;
  if (candidate.certain && candidate.high < candidates->best) candidates->best = candidate.high;
  candidates->looked_at += TP_REST_EXACT_LOOKS; /* most are looked at again, in exact numbers */
  if (isinf(candidate.high)) candidates->blind++;
  candidates->too_many = candidates->count >= TP_BUDGET_REST_CANDIDATES;
  candidates->too_blind = candidates->blind > TP_BUDGET_REST_BLIND;
  if (candidates->too_many || candidates->too_blind) return false;
  tp_candidate *room =
      tp_grow(candidates->items, candidates->count, &candidates->capacity, sizeof *room);
  if (room == NULL) return false;
  candidates->items = room;
  candidates->items[candidates->count++] = candidate;
  return true;
}

void tp_candidates_settle(tp_candidates *candidates) {
  long kept = 0;
  for (long k = 0; k < candidates->count; k++) {
    if (candidates->items[k].low <= candidates->best) {
      candidates->items[kept++] = candidates->items[k];
    }
  }
  candidates->count = kept;
}

void tp_candidates_reach(long *first, long *last, const tp_bodies *bodies, double low,
                         double high) {
  const double *u = bodies->base.u; /* falling along the profile */
  long a = 0, b = bodies->profile_count - 1;
  while (a < b) { /* the last vertex of those at `high` or beyond */
    const long middle = (a + b + 1) / 2;
    if (u[middle] >= high) {
      a = middle;
    } else {
      b = middle - 1;
    }
  }
  *first = a;
  b = bodies->profile_count - 1;
  while (a < b) { /* the first of those at `low` or beyond */
    const long middle = (a + b) / 2;
    if (u[middle] <= low) {
      b = middle;
    } else {
      a = middle + 1;
    }
  }
  *last = a;
}
