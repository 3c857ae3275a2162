/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sorted zeros in degrees, and the critical angle among them: the first above level where level
 * ground is stable, otherwise the last below (docs/mechanics.md section 5). */

#include "load/roots.h"

void tp_roots_init(tp_roots *roots) {
  roots->count = 0;
  roots->certain = true;
  for (int k = 0; k < TP_ROOTS_MAX; k++) arb_init(roots->degrees + k);
}

void tp_roots_clear(tp_roots *roots) {
  for (int k = 0; k < TP_ROOTS_MAX; k++) arb_clear(roots->degrees + k);
}

static void to_degrees(arb_t degrees, const arb_t radians, long bits) {
  arb_t pi;
  arb_init(pi);
  arb_const_pi(pi, bits);
  arb_mul_ui(degrees, radians, 180, bits);
  arb_div(degrees, degrees, pi, bits);
  arb_clear(pi);
}

void tp_roots_keep(tp_roots *roots, const arb_t radians, bool rising, long bits) {
  if (roots->count == TP_ROOTS_MAX) {
    roots->certain = false;
    return;
  }
  long at = roots->count++;
  arb_t degrees;
  arb_init(degrees);
  to_degrees(degrees, radians, bits);
  for (; at > 0 && arf_cmp(arb_midref(roots->degrees + at - 1), arb_midref(degrees)) > 0; at--) {
    arb_swap(roots->degrees + at, roots->degrees + at - 1);
    roots->rising[at] = roots->rising[at - 1];
  }
  arb_swap(roots->degrees + at, degrees);
  roots->rising[at] = rising;
  arb_clear(degrees);
}

/* The zero that may be level ground itself: its index where it is the only one and rising, else -1.
 * If what is level is stable by less than its ball tells, it is the first zero above; if not, the
 * last one below; if it is just in balance, it is level: in all cases the one within the ball. */
static long zero_at_level(const tp_roots *roots) {
  long found = -1;
  for (long k = 0; k < roots->count; k++) {
    if (!arb_contains_zero(roots->degrees + k)) continue;
    if (found >= 0 || !roots->rising[k]) return -1;
    found = k;
  }
  return found;
}

bool tp_roots_critical(arb_t degrees, bool *always, tp_roots *roots, const arb_t level) {
  const bool stable = arb_is_negative(level) != 0;
  *always = !stable;
  if (!stable && !arb_is_positive(level)) {
    const long at = zero_at_level(roots);
    if (at >= 0) {
      arb_set(degrees, roots->degrees + at);
      return true;
    }
    roots->certain = false;
  }
  bool found = false;
  for (long k = 0; k < roots->count; k++) {
    if (arb_contains_zero(roots->degrees + k)) roots->certain = false; /* on which side of level? */
    const bool above = arf_sgn(arb_midref(roots->degrees + k)) > 0;
    if (!roots->rising[k] || above != stable) continue;
    arb_set(degrees, roots->degrees + k);
    found = true;
    if (stable) break; /* the first above; of those below the last */
  }
  return found;
}
