/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A derivation as JSON. */

#include "host.h"
#include "output/json.h"
#include "report/derived_limit.h"
#include "report/derived_onset.h"
#include "report/notes.h"
#include "report/parts_json.h"
#include "report/words.h"

static void add_elements_form(tp_text *t, const tp_derived_pivot *p) {
  if (!p->has_elements) return;
  tp_text_add(t, ",\n     \"fos_elements\": {");
  tp_json_fraction(t, "stabilising_cos", &p->normal_stabilising);
  tp_text_add(t, ",\n       ");
  tp_json_fraction(t, "stabilising_sin", &p->parallel_stabilising);
  tp_text_add(t, ",\n       ");
  tp_json_fraction(t, "overturning_cos", &p->normal_overturning);
  tp_text_add(t, ",\n       ");
  tp_json_fraction(t, "overturning_sin", &p->parallel_overturning);
  if (p->splits) {
    tp_text_add(t, ",\n       ");
    tp_json_fraction(t, "cot", &p->fos_cot);
    tp_text_add(t, ",\n       ");
    tp_json_fraction(t, "constant", &p->fos_constant);
  }
  tp_text_add(t, "}");
}

static void add_pivot(tp_text *t, const tp_derived_pivot *p) {
  tp_text_add(
      t, "    {\"towards\": \"%s\", \"kind\": \"%s\", \"admissible\": %s, \"governs\": %s,\n     ",
      tp_text_direction(p->towards), tp_text_pivot_kind(p->kind), tp_json_truth(p->admissible),
      tp_json_truth(p->governs));
  tp_json_fraction(t, "x", &p->x);
  tp_text_add(t, ", ");
  tp_json_fraction(t, "y", &p->y);
  tp_text_add(t, ",\n     ");
  tp_json_fraction(t, "tan_critical_angle", &p->tangent);
  tp_text_add(t, ",\n     ");
  tp_json_number(t, "critical_angle_deg", p->critical_angle_deg);
  add_elements_form(t, p);
  tp_text_add(t, "}");
}

/* Where rounded corners were asked for. */
static void add_rounded(tp_text *t, const tp_derivation *d) {
  const char *separator = ",\n  \"rounded\": [\n    ";
  bool any = false;
  for (int k = 0; k < 2; k++) {
    const tp_derived_rounding *r = d->rounded + k;
    if (!r->known) continue;
    tp_text_add(t, "%s{\"towards\": \"%s\", \"kind\": \"%s\",\n     ", separator,
                tp_text_direction((tp_direction)k), tp_text_pivot_kind(r->kind));
    tp_json_fraction(t, "tan_critical_angle", &r->tangent);
    tp_text_add(t, ",\n     ");
    tp_json_fraction(t, "rounding_length", &r->length);
    if (r->has_radius) {
      tp_text_add(t, ",\n     ");
      tp_json_fraction(t, "corner_radius", &r->radius);
    }
    tp_text_add(t, "}");
    separator = ",\n    ";
    any = true;
  }
  if (any) tp_text_add(t, "\n  ]");
}

tp_status tp_report_derivation_json(char **text, const tp_derivation *derivation) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, derivation);
  tp_text t = {0};
  tp_text_add(&t, "{\n  \"topple\": \"%s\",\n  \"symbols\": [", TP_VERSION);
  for (size_t k = 0; k < derivation->symbol_count; k++) {
    tp_text_add(&t, "%s", k > 0 ? ", " : "");
    tp_encode_json(&t, derivation->symbols[k]);
  }
  tp_text_add(&t, "],\n");
  tp_json_notes(&t, &derivation->notes);
  tp_text_add(&t, "  ");
  tp_json_fraction(&t, "area", &derivation->area);
  tp_text_add(&t, ",\n  ");
  tp_json_fraction(&t, "x_moment", &derivation->x_moment);
  tp_text_add(&t, ",\n  ");
  tp_json_fraction(&t, "y_moment", &derivation->y_moment);
  tp_text_add(&t, ",\n  \"pivots\": [\n");
  for (size_t k = 0; k < derivation->pivot_count; k++) {
    add_pivot(&t, derivation->pivots + k);
    tp_text_add(&t, "%s\n", k + 1 < derivation->pivot_count ? "," : "");
  }
  tp_text_add(&t, "  ]");
  add_rounded(&t, derivation);
  tp_json_derived_limit(&t, derivation);
  tp_json_derived_onset(&t, derivation);
  tp_text_add(&t, "\n}\n");
  return tp_text_finish(&t, text);
}
