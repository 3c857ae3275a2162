/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The limit's formula, reactions and conditions for each direction in text, LaTeX, C and JSON
 * (docs/mechanics.md section 9). */

#include "report/derived_limit.h"

#include "report/conditions.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

/* "slides and topples, towards the left, on a base that ends at the toe, 28.735 degrees …" */
static void add_description(tp_text *t, const tp_derived_limit *l, tp_direction towards) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "%s, towards the %s, on a base that %s,\n%s degrees at the scene's values",
              tp_mechanism_name(l->mechanism), tp_direction_name(towards),
              l->base_beyond_toe ? "extends past the toe" : "ends at the toe",
              tp_text_fixed(n, l->critical_angle_deg, 3));
}

static tp_condition_list conditions_of(const tp_derived_limit *l) {
  return (tp_condition_list){.what = "limit",
                             .zeros = true,
                             .positive = l->parameters_above_zero,
                             .count = l->condition_count,
                             .items = l->conditions,
                             .checks = &l->checks};
}

static void add_text(tp_text *t, const tp_derived_limit *l, tp_direction towards) {
  tp_text_add(t, "\nLimit: ");
  add_description(t, l, towards);
  tp_text_add(t, "\n  tan(alpha_crit) = %s\n  held by forces at", l->tan_critical_angle.formula);
  for (int k = 0; k < 2; k++) {
    const tp_derived_reaction *r = l->reactions + k;
    tp_text_add(t, "%s (%s, %s), friction acting %s", k == 0 ? "" : " and", r->x.formula,
                r->y.formula, r->against_slip ? "up-dip" : "down-dip");
  }
  if (l->has_centre) {
    tp_text_add(t, "\n  which meet the weight in the centre of rotation\n    x = %s\n    y = %s",
                l->centre_x.formula, l->centre_y.formula);
  }
  const tp_condition_list conditions = conditions_of(l);
  tp_text_conditions(t, &conditions);
}

void tp_text_derived_limit(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    if (d->limit[k].known) add_text(t, d->limit + k, (tp_direction)k);
    if (!d->limit[k].known && d->limit[k].mechanism == TP_INTERLOCKED) {
      tp_text_add(t, "\nLimit: none, towards the %s forces hold it at any tilt\n",
                  tp_direction_name((tp_direction)k));
    }
  }
}

void tp_latex_derived_limit(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_limit *l = d->limit + k;
    if (!l->known) continue;
    tp_text_add(t, "%% limit: %s, towards the %s, on a base that %s\n",
                tp_mechanism_name(l->mechanism), tp_direction_name((tp_direction)k),
                l->base_beyond_toe ? "extends past the toe" : "ends at the toe");
    tp_text_add(t, "\\[ \\tan\\alpha_{\\mathrm{crit}} = %s \\]\n", l->tan_critical_angle.formula);
    const tp_condition_list conditions = conditions_of(l);
    tp_latex_conditions(t, &conditions);
  }
}

/* Angles in radians. */
void tp_c_derived_limit(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_limit *l = d->limit + k;
    const char *side = tp_direction_name((tp_direction)k);
    if (!l->known) continue;
    tp_text_add(t, "\n/* limit: ");
    add_description(t, l, (tp_direction)k);
    const tp_condition_list conditions = conditions_of(l);
    tp_c_conditional(t, &conditions, d, l->tan_critical_angle.formula, side);
  }
}

/* Is there a limit, or none because forces hold the block at any tilt? */
bool tp_derived_limit_is_told(const tp_derived_limit *l) {
  return l->known || l->mechanism == TP_INTERLOCKED;
}
