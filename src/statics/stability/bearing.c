/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Matches pivots with the contact points of the limit's reactions, within their error bounds. */

#include "stability/bearing.h"

#include <math.h>

static bool is_at(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

bool tp_pivot_bears(const tp_pivot *pivot, const tp_limit *limit) {
  for (size_t k = 0; k < limit->reaction_count; k++) {
    const tp_reaction *force = limit->reactions + k;
    if (is_at(force->x_m, pivot->x_m) && is_at(force->y_m, pivot->y_m)) return true;
  }
  return false;
}
