/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Several solutions in one table. */

#include "host.h"
#include "report/encode.h"

static void add_angle(tp_text *t, bool known, tp_bounded angle) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, " | %s%s", known ? tp_text_fixed(n, angle, 3) : "-", known ? "°" : "");
}

static void add_limit(tp_text *t, const tp_limit *l) {
  add_angle(t, l->kind == TP_LIMIT_AT_ANGLE, l->critical_angle_deg);
  const bool nowhere = l->kind == TP_LIMIT_NOWHERE || l->kind == TP_LIMIT_NOT_ASKED;
  tp_text_add(t, " | %s", nowhere ? "-" : tp_text_mechanism(l->mechanism));
  if (l->tie) tp_text_add(t, ", %s", tp_text_mechanism(l->tied_with));
}

static void add_case(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_pivot *pivot = c->has_governing ? c->pivots + c->governing : NULL;
  const bool goes_on = c->limit.base_beyond_toe;
  tp_text_add(t, "| ");
  tp_encode_markdown(t, s->title != NULL ? s->title : "a scene");
  tp_text_add(t, " | %s | %s", tp_text_direction(c->towards),
              pivot != NULL ? tp_text_pivot_kind(pivot->kind) : "-");
  add_angle(t, pivot != NULL && !pivot->never && !pivot->always,
            pivot != NULL ? pivot->critical_angle_deg : (tp_bounded){0});
  add_angle(t, c->sliding.known && !c->sliding.never && !c->sliding.always,
            c->sliding.critical_angle_deg);
  add_limit(t, goes_on ? &c->limit_otherwise : &c->limit);
  add_limit(t, goes_on ? &c->limit : &c->limit_otherwise);
  tp_text_add(t, " |\n");
}

tp_status tp_report_table(char **text, const tp_solution *const *solutions, size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solutions);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, solutions[k]);
  tp_text t = {0};
  tp_text_add(&t, "| scene | towards | toe | moments | φ_b + i | base ends at the toe: limit | "
                  "mechanism | base goes on: limit | mechanism |\n"
                  "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (size_t k = 0; k < count; k++) {
    for (size_t c = 0; c < solutions[k]->case_count; c++) {
      add_case(&t, solutions[k], solutions[k]->cases + c);
    }
  }
  return tp_text_finish(&t, text);
}
