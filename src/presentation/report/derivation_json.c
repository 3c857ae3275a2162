/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A derivation as JSON: fractions of each pivot, elements form, limit, onset and rounding. */

#include "common/host.h"
#include "output/json.h"
#include "report/derived_limit.h"
#include "report/derived_onset.h"
#include "report/notes.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

static void add_fraction_below(tp_json *j, const char *key, const tp_fraction *f) {
  tp_json_break(j);
  tp_json_fraction(j, key, f);
}

static void add_elements_form(tp_json *j, const tp_derived_pivot *p) {
  if (!p->has_elements) return;
  tp_json_break(j);
  tp_json_object(j, "fos_elements", TP_JSON_LINE);
  tp_json_fraction(j, "stabilising_cos", &p->normal_stabilising);
  add_fraction_below(j, "stabilising_sin", &p->parallel_stabilising);
  add_fraction_below(j, "overturning_cos", &p->normal_overturning);
  add_fraction_below(j, "overturning_sin", &p->parallel_overturning);
  if (p->splits) {
    add_fraction_below(j, "cot", &p->fos_cot);
    add_fraction_below(j, "constant", &p->fos_constant);
  }
  tp_json_close(j);
}

static void add_pivot(tp_json *j, const tp_derived_pivot *p) {
  tp_json_object(j, NULL, TP_JSON_ALIGNED);
  tp_json_string(j, "towards", tp_direction_name(p->towards));
  tp_json_string(j, "kind", tp_pivot_kind_name(p->kind));
  tp_json_truth(j, "admissible", p->admissible);
  tp_json_truth(j, "governs", p->governs);
  add_fraction_below(j, "x", &p->x);
  tp_json_fraction(j, "y", &p->y);
  add_fraction_below(j, "tan_critical_angle", &p->tangent);
  tp_json_break(j);
  tp_json_bounded(j, "critical_angle_deg", p->critical_angle_deg);
  add_elements_form(j, p);
  tp_json_close(j);
}

static void add_rounding(tp_json *j, const tp_derived_rounding *r, tp_direction towards) {
  tp_json_object(j, NULL, TP_JSON_ALIGNED);
  tp_json_string(j, "towards", tp_direction_name(towards));
  tp_json_string(j, "kind", tp_pivot_kind_name(r->kind));
  add_fraction_below(j, "tan_critical_angle", &r->tangent);
  add_fraction_below(j, "rounding_length", &r->length);
  if (r->has_radius) add_fraction_below(j, "corner_radius", &r->radius);
  tp_json_close(j);
}

/* Where rounded corners were asked for. */
static void add_rounded(tp_json *j, const tp_derivation *d) {
  if (!d->rounded[0].known && !d->rounded[1].known) return;
  tp_json_array(j, "rounded", TP_JSON_BLOCK);
  for (int k = 0; k < 2; k++) {
    if (d->rounded[k].known) add_rounding(j, d->rounded + k, (tp_direction)k);
  }
  tp_json_close(j);
}

tp_status tp_report_derivation_json(char **text, const tp_derivation *derivation) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, derivation);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_array(&j, "symbols", TP_JSON_LINE);
  for (size_t k = 0; k < derivation->symbol_count; k++) {
    tp_json_string(&j, NULL, derivation->symbols[k]);
  }
  tp_json_close(&j);
  tp_json_notes(&j, &derivation->notes);
  tp_json_fraction(&j, "area", &derivation->area);
  tp_json_fraction(&j, "x_moment", &derivation->x_moment);
  tp_json_fraction(&j, "y_moment", &derivation->y_moment);
  tp_json_array(&j, "pivots", TP_JSON_BLOCK);
  for (size_t k = 0; k < derivation->pivot_count; k++) add_pivot(&j, derivation->pivots + k);
  tp_json_close(&j);
  add_rounded(&j, derivation);
  tp_json_derived_limit(&j, derivation);
  tp_json_derived_onset(&j, derivation);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
