/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which shaking overturns a block, as a page tells it: what was tried, and no more. */

#include "report/tilt_text.h"

#include <math.h>

static const double standard_gravity = 9.80665;
/* Ranges that are told one by one; the JSON has all. */
enum { MOST_RANGES = 12 };

/* By how much of itself each factor of a grid is above the one before, in per cent. */
static double step_of(const tp_overturning_grid *grid) {
  return 100 * (pow(grid->most / grid->least, 1 / (double)(grid->count - 1)) - 1);
}

static void add_grid(tp_text *t, const tp_overturning_grid *grid) {
  if (grid->count == 1) {
    tp_text_add(t, "%.4g", grid->least);
  } else {
    tp_text_add(t, "%zu from %.4g to %.4g, %.2g %% apart", grid->count, grid->least, grid->most,
                step_of(grid));
  }
}

static void add_tried(tp_text *t, const tp_tilt_case *c) {
  tp_text_add(t, "\n  Factors applied to this shaking: ");
  if (c->overturning_tried_count == 0) tp_text_add(t, "none");
  for (size_t k = 0; k < c->overturning_tried_count; k++) {
    if (k > 0) tp_text_add(t, ",\n  and ");
    add_grid(t, c->overturning_tried + k);
  }
  tp_text_add(t, ".\n");
  if (!c->converged) {
    tp_text_add(t, "  A run was undecided or interrupted: the search ended there.\n");
  }
}

static void add_range(tp_text *t, const tp_overturning_range *r) {
  tp_text_add(t, "    %.4g to %.4g", r->least, r->most);
  if (isnan(r->spared_below) && isnan(r->spared_above)) {
    tp_text_add(t, ", all those tried");
  } else if (isnan(r->spared_below)) {
    tp_text_add(t, ", from the least tried; not overturned by %.4g", r->spared_above);
  } else if (isnan(r->spared_above)) {
    tp_text_add(t, ", the greatest tried; not overturned by %.4g", r->spared_below);
  } else {
    tp_text_add(t, "; not overturned by %.4g or %.4g", r->spared_below, r->spared_above);
  }
  tp_text_add(t, "\n");
}

static void add_least(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  const tp_tilt_shaking *own = test->shaking;
  tp_text_add(t, "  The least of them is %.4g", c->overturned_by);
  if (own->given) {
    tp_text_add(t, ": PGA %.4g g, PGV %.4g m/s",
                c->overturned_by * own->peak_m_s2 / standard_gravity,
                c->overturned_by * own->peak_velocity_m_s);
  }
  tp_text_add(t, ".\n  Between two factors tried the result may differ, and less may overturn it:\n"
                 "  --factors tries more.\n");
}

void tp_tilt_add_peak(tp_text *t, const tp_tilt_case *c) {
  if (!c->has_peak_turn || c->end == TP_TILT_OVERTURNED || c->end == TP_TILT_LEFT_BASE) return;
  tp_text_add(t, "  It turned by up to %.4g°, at %.4g s", fabs(c->peak_turn_deg), c->peak_turn_s);
  if (c->has_balance_turn) {
    tp_text_add(t, ": %.3g %% of its balance angle of %.4g°", 100 * c->peak_over_balance,
                c->balance_turn_deg);
  }
  tp_text_add(t, ".\n");
  if (c->has_balance_turn && c->peak_over_balance > 1) {
    tp_text_add(t, "  Caution: beyond its balance angle only the shaking brought it back.\n");
  }
}

/* Weaker shaking overturns what the scene's own does not. */
static bool is_overturned_below(const tp_tilt_case *c) {
  return c->has_overturning && c->overturned_by < 1 && c->end != TP_TILT_OVERTURNED &&
         c->end != TP_TILT_LEFT_BASE;
}

void tp_tilt_add_overturning(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  if (!c->overturning_scanned) return;
  add_tried(t, c);
  if (is_overturned_below(c)) {
    tp_text_add(t, "  Caution: weaker shaking overturns it.\n");
  }
  if (!c->has_overturning) {
    tp_text_add(t, "  None of them overturns it, or throws it off its base.\n");
    return;
  }
  tp_text_add(t, "  It was overturned, or thrown off its base, by all tried from\n");
  for (size_t k = 0; k < c->overturning_range_count && k < MOST_RANGES; k++) {
    add_range(t, c->overturning_ranges + k);
  }
  if (c->overturning_range_count > MOST_RANGES) {
    tp_text_add(t, "    and in %zu more ranges (listed by --json)\n",
                c->overturning_range_count - MOST_RANGES);
  }
  add_least(t, c, test);
}
