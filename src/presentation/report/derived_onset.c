/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset's formula, the forces and twists that balance the weight, and conditions for each
 * direction in text, LaTeX, C and JSON (docs/mechanics.md section 9). */

#include "report/derived_onset.h"

#include "report/conditions.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

/* "topples, towards the left, 26.215 degrees at the scene's values, below the limit" */
static void add_description(tp_text *t, const tp_derived_onset *o, tp_direction towards) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "%s, towards the %s, %s degrees at the scene's values%s",
              tp_mechanism_name(o->mechanism), tp_direction_name(towards),
              tp_text_fixed(n, o->critical_angle_deg, 3),
              o->below_limit ? ", below the limit" : "");
}

static tp_condition_list conditions_of(const tp_derived_onset *o) {
  return (tp_condition_list){.what = "onset",
                             .zeros = false,
                             .positive = o->parameters_above_zero,
                             .count = o->condition_count,
                             .items = o->conditions,
                             .checks = &o->checks};
}

/* Why there is no formula; NULL where there is one, or none was asked for. */
const char *tp_derived_onset_missing(const tp_derived_onset *o) {
  if (o->known || o->kind == TP_ONSET_NOT_ASKED) return NULL;
  return o->reason != NULL ? o->reason : "no motion can begin at any tilt up to 90 degrees";
}

/* What balances the weight. */
static void add_row(tp_text *t, const tp_derived_row *r) {
  if (r->is_force) {
    tp_text_add(t, "\n    a force at (%s, %s), friction acting %s", r->x.formula, r->y.formula,
                r->against_slip ? "up-dip" : "down-dip");
  } else if (r->turns) {
    tp_text_add(t, "\n    what turns the block about (%s, %s)", r->x.formula, r->y.formula);
  } else {
    tp_text_add(t, "\n    what moves the block along a facet");
  }
}

static void add_text(tp_text *t, const tp_derived_onset *o, tp_direction towards) {
  tp_text_add(t, "\nOnset of motion: ");
  add_description(t, o, towards);
  if (o->same_as_limit) {
    tp_text_add(t, "\n  the formula of the limit serves for both");
  } else {
    tp_text_add(t, "\n  tan(alpha_s) = %s", o->tan_critical_angle.formula);
  }
  tp_text_add(t, "\n  the weight in balance with");
  for (int k = 0; k < 2; k++) add_row(t, o->balance + k);
  const tp_condition_list conditions = conditions_of(o);
  tp_text_conditions(t, &conditions);
}

void tp_text_derived_onset(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_onset *o = d->onset + k;
    if (o->known) add_text(t, o, (tp_direction)k);
    if (tp_derived_onset_missing(o) != NULL) {
      tp_text_add(t, "\nOnset of motion: no formula, towards the %s:\n  %s\n",
                  tp_direction_name((tp_direction)k), tp_derived_onset_missing(o));
    }
  }
}

void tp_latex_derived_onset(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_onset *o = d->onset + k;
    if (tp_derived_onset_missing(o) != NULL) {
      tp_text_add(t, "%% onset of motion: no formula, towards the %s: %s\n",
                  tp_direction_name((tp_direction)k), tp_derived_onset_missing(o));
    }
    if (!o->known) continue;
    tp_text_add(t, "%% onset of motion: ");
    add_description(t, o, (tp_direction)k);
    tp_text_add(t, "\n\\[ \\tan\\alpha_{\\mathrm{s}} = %s \\]\n", o->tan_critical_angle.formula);
    const tp_condition_list conditions = conditions_of(o);
    tp_latex_conditions(t, &conditions);
  }
}

/* Angles in radians. */
void tp_c_derived_onset(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_onset *o = d->onset + k;
    const char *side = tp_direction_name((tp_direction)k);
    if (tp_derived_onset_missing(o) != NULL) {
      tp_text_add(t, "\n/* onset of motion: no formula, towards the %s: %s */\n", side,
                  tp_derived_onset_missing(o));
    }
    if (!o->known) continue;
    tp_text_add(t, "\n/* onset of motion: ");
    add_description(t, o, (tp_direction)k);
    const tp_condition_list conditions = conditions_of(o);
    tp_c_conditional(t, &conditions, d, o->tan_critical_angle.formula, side);
  }
}
