/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Goodman and Bray's method on the page of many blocks, beside the free limit that it is held
 * against. */

#include "report/column_page.h"

#include "report/system_page.h"
#include "terms/names.h"

/* Doubles without a bound: digits that their rounding does not reach. */
static const tp_bounded *rounded(tp_bounded *number, double value) {
  *number = (tp_bounded){value, 0, NULL};
  return number;
}

void tp_text_goodman_bray_factor(tp_text *t, const tp_goodman_bray *own) {
  char n[TP_NUMBER_SIZE];
  tp_bounded number;
  if (!own->has_fos) {
    tp_text_add(t, "none: no greater friction is enough");
  } else {
    tp_text_add(t, "%s%s", own->fos_is_least ? "above " : "",
                tp_text_fixed_down(n, *rounded(&number, own->fos), own->fos_is_least ? 0 : 5));
  }
}

static void add_factor(tp_text *t, const tp_goodman_bray *own) {
  char n[TP_NUMBER_SIZE];
  tp_bounded number;
  tp_text_system_label(t, "factor of safety, Goodman and Bray");
  tp_text_goodman_bray_factor(t, own);
  tp_text_add(t, "\n");
  if (own->has_friction_angle) {
    tp_text_system_label(t, "at a friction angle of");
    tp_text_add(t, "%s°\n", tp_text_fixed(n, *rounded(&number, own->friction_angle_deg), 4));
  }
  if (own->has_support) {
    tp_text_system_label(t, "support at the toe, horizontal");
    if (own->support_n_m > 0) {
      tp_text_add(t, "%.5g kN/m\n", own->support_n_m / 1e3);
    } else {
      tp_text_add(t, "none needed\n");
    }
  }
}

bool tp_goodman_bray_cost(double *ratio, const tp_system_case *c) {
  const tp_goodman_bray *own = &c->goodman_bray;
  if (!own->applies || !own->has_fos || own->fos_is_least) return false;
  if (c->fos.state != TP_FOS_NUMBER || c->fos_is_least) return false;
  *ratio = c->fos.value.value / own->fos;
  return true;
}

/* What the assumption costs, by both factors. Forces that hold all columns are some of those that
 * limit analysis has, so that its factor is the greater. */
static void add_assumption(tp_text *t, const tp_system_case *c) {
  static const double rounding = 1e-6;
  const tp_goodman_bray *own = &c->goodman_bray;
  double ratio = 1;
  const bool both = tp_goodman_bray_cost(&ratio, c);
  tp_text_add(t, "  Its forces between columns act at the top of each contact, with the friction\n"
                 "  there fully mobilised.");
  if (ratio < 1 - rounding) {
    tp_text_add(t, " Some of them cannot be here: the factor by strength\n"
                   "  reduction is the smaller one.\n");
    return;
  }
  if (both && ratio <= 1 + rounding) {
    tp_text_add(t, " No forces that act elsewhere need less\n"
                   "  friction.");
  } else if (both) {
    tp_text_add(t,
                " It asks for %.4g times the friction that forces need\n"
                "  which act where it is best.",
                ratio);
  }
  tp_text_add(t, c->has_moving_fos && own->has_fos && c->moving_fos < own->fos
                     ? " For columns it is the cautious one of the two, but\n"
                       "  a motion can begin at a smaller factor still.\n"
                     : " For columns it is the cautious one of the two.\n");
}

void tp_text_goodman_bray_zones(tp_text *t, const tp_goodman_bray *own,
                                const tp_language *language) {
  static const char *const one[] = {[TP_COLUMN_STABLE] = "stable %zu",
                                    [TP_COLUMN_TOPPLES] = "toppling %zu",
                                    [TP_COLUMN_SLIDES] = "sliding %zu"};
  static const char *const several[] = {[TP_COLUMN_STABLE] = "stable %zu to %zu",
                                        [TP_COLUMN_TOPPLES] = "toppling %zu to %zu",
                                        [TP_COLUMN_SLIDES] = "sliding %zu to %zu"};
  for (size_t k = 0, next = 0; k < own->column_count; k = next) {
    const tp_column_state state = own->columns[k].state;
    while (next < own->column_count && own->columns[next].state == state) next++;
    if (k > 0) tp_text_add(t, ", ");
    tp_text_add(t, tp_say(language, next > k + 1 ? several[state] : one[state]), k + 1, next);
  }
}

static void add_columns(tp_text *t, const tp_block_system *s, const tp_goodman_bray *own,
                        int width) {
  bool all_hold = true;
  tp_text_add(t, "\n  Columns from the toe up, at the friction that there is:\n");
  tp_text_add(t, "  %-*s  %-7s", width, "column", "state");
  if (own->has_forces) {
    tp_text_add(t, "  %12s  %12s  %12s", "topple kN/m", "slide kN/m", "passed on");
  }
  tp_text_add(t, "\n");
  for (size_t k = 0; k < own->column_count; k++) {
    const tp_goodman_bray_column *c = own->columns + k;
    all_hold = all_hold && c->base_holds;
    if (k >= TP_SYSTEM_ROWS) continue;
    tp_text_add(t, "  ");
    tp_text_system_name(t, s->blocks[c->block].name, width);
    tp_text_add(t, "  %-7s", tp_column_state_name(c->state));
    if (own->has_forces) {
      tp_text_add(t, "  %12.1f  %12.1f  %12.1f", c->toppling_n_m / 1e3, c->sliding_n_m / 1e3,
                  c->push_n_m / 1e3);
    }
    tp_text_add(t, "\n");
  }
  tp_text_more_rows(t, own->column_count);
  tp_text_add(t, "  Zones from the toe up: ");
  tp_text_goodman_bray_zones(t, own, NULL);
  tp_text_add(t, ".\n");
  if (!all_hold) {
    tp_text_add(t, "  Under some columns the base would have to pull, or slip up the slope: there\n"
                   "  the method's forces cannot be (base_holds in --json).\n");
  }
}

void tp_text_goodman_bray(tp_text *t, const tp_block_system *s, const tp_system_case *c,
                          int width) {
  const tp_goodman_bray *own = &c->goodman_bray;
  if (!own->applies) {
    char why[512];
    tp_plain_text(why, sizeof why, own->why_not);
    tp_text_add(t, "  Goodman and Bray (1976) does not apply:\n  %s.\n", why);
    return;
  }
  add_factor(t, own);
  add_assumption(t, c);
  if (own->column_count > 0) add_columns(t, s, own, width);
}
