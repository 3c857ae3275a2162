/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A verification as text. */

#include "report/report_claims.h"
#include "host.h"

#include <string.h>

bool tp_claim_objects(const tp_claim_result *claim) {
  return claim->verdict == TP_VERDICT_REFUTED || claim->verdict == TP_VERDICT_DISAGREES;
}

void tp_claims_add_tally(tp_text *t, const tp_verification *v) {
  tp_text_add(t, "%zu claims: ", v->count);
  const char *separator = "";
  for (int k = 0; k < TP_VERDICTS; k++) {
    if (v->tally[k] == 0) continue;
    tp_text_add(t, "%s%zu %s", separator, v->tally[k], tp_verdict_name((tp_verdict)k));
    separator = ", ";
  }
}

/* Decimals in a printed number. */
static int decimals(const char *printed) {
  const char *point = strchr(printed, '.');
  return point != NULL ? (int)strspn(point + 1, "0123456789") : 0;
}

const char *tp_claim_number(char out[TP_NUMBER_SIZE], const tp_claim_result *c, tp_bounded number) {
  if (c->is_formula) return tp_text_significant(out, number, 8);
  const bool relation = strpbrk(c->printed, "<>") != NULL;
  return tp_text_fixed(out, number, decimals(c->printed) + (relation ? 4 : 2));
}

void tp_claim_add_outcome(tp_text *t, const tp_claim_result *c) {
  char number[TP_NUMBER_SIZE];
  if (c->is_formula) {
    if (c->verdict == TP_VERDICT_AGREES) {
      tp_text_add(t, "agrees to %d digits at %d points", c->digits, c->points);
    }
    return;
  }
  const char *unit = c->unit != NULL ? c->unit : "";
  const char *space = c->unit != NULL && strcmp(c->unit, "°") != 0 ? " " : "";
  tp_text_add(t, "printed %s%s%s, computed %s%s%s", c->printed, space, unit,
              tp_claim_number(number, c, c->computed), space, unit);
}

static void add_detail(tp_text *t, const char *what, const char *text) {
  if (text != NULL) tp_text_add(t, "             %-11s%s\n", what, text);
}

static void add_claim(tp_text *t, const tp_claim_result *c) {
  tp_text_add(t, "%-11s%-24s %-10s ", tp_verdict_name(c->verdict), c->id, c->where);
  tp_claim_add_outcome(t, c);
  tp_text_add(t, "\n");
  if (!tp_claim_objects(c)) return;
  if (c->is_formula) {
    char one[TP_NUMBER_SIZE], other[TP_NUMBER_SIZE];
    add_detail(t, "printed", c->printed);
    add_detail(t, c->is_tangent ? "tangent" : "derived", c->derived);
    add_detail(t, "difference", c->difference);
    if (c->has_values) {
      tp_text_add(t, "             at         %s: printed %s, derived %s\n", c->values,
                  tp_claim_number(one, c, c->printed_value),
                  tp_claim_number(other, c, c->computed));
    }
    add_detail(t, "mend", c->change);
    add_detail(t, "", c->mend);
  }
  add_detail(t, "note", c->note);
}

tp_status tp_report_verification(char **text, const tp_verification *v) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, v);
  tp_text t = {0};
  if (v->title != NULL) tp_text_add(&t, "%s\n", v->title);
  if (v->source != NULL) tp_text_add(&t, "%s\n", v->source);
  tp_text_add(&t, "\n");
  for (size_t k = 0; k < v->count; k++) add_claim(&t, v->claims + k);
  tp_text_add(&t, "\n");
  tp_claims_add_tally(&t, v);
  tp_text_add(&t, "\n");
  return tp_text_finish(&t, text);
}
