/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A verification as text: a tally, then each claim with its verdict, values and mend. */

#include "report/claims.h"
#include "common/host.h"

#include "output/encode.h"

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

static void add_plain(tp_text *t, const char *before, const char *outside) {
  tp_text_add(t, "%s", before);
  tp_encode_plain(t, outside);
}

static void add_markdown(tp_text *t, const char *before, const char *outside) {
  tp_text_add(t, "%s", before);
  tp_encode_markdown(t, outside);
}

void tp_claim_add_outcome(tp_text *t, const tp_claim_result *c, tp_claim_page page) {
  void (*const add)(tp_text *, const char *, const char *) =
      page == TP_CLAIM_MARKDOWN ? add_markdown : add_plain;
  char number[TP_NUMBER_SIZE];
  if (c->is_formula) {
    if (c->verdict == TP_VERDICT_AGREES) {
      tp_text_add(t, "agrees to %d digits at %d points", c->digits, c->points);
    }
    return;
  }
  const char *unit = c->unit != NULL ? c->unit : "";
  const char *space = c->unit != NULL && strcmp(c->unit, "°") != 0 ? " " : "";
  add(t, "printed ", c->printed);
  add(t, space, unit);
  tp_text_add(t, ", computed %s", tp_claim_number(number, c, c->computed_there));
  add(t, space, unit);
}

static void add_detail(tp_text *t, const char *what, const char *text) {
  if (text == NULL) return;
  tp_text_add(t, "             %-11s", what);
  tp_encode_plain(t, text);
  tp_text_add(t, "\n");
}

static void add_claim(tp_text *t, const tp_claim_result *c) {
  tp_text_add(t, "%-11s", tp_verdict_name(c->verdict));
  tp_encode_column(t, c->id, 24);
  tp_text_add(t, " ");
  tp_encode_column(t, c->where, 10);
  tp_text_add(t, " ");
  tp_claim_add_outcome(t, c, TP_CLAIM_PLAIN);
  tp_text_add(t, "\n");
  add_detail(t, "", c->condition);
  if (!tp_claim_objects(c)) return;
  if (c->is_formula) {
    char one[TP_NUMBER_SIZE], other[TP_NUMBER_SIZE];
    add_detail(t, "printed", c->printed);
    add_detail(t, c->of_tangents ? "tangent" : "derived", c->computed);
    add_detail(t, "difference", c->difference);
    if (c->has_values) {
      tp_text_add(t, "             at         ");
      tp_encode_plain(t, c->at);
      tp_text_add(t, ": printed %s, derived %s\n", tp_claim_number(one, c, c->printed_there),
                  tp_claim_number(other, c, c->computed_there));
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
  const char *const lines[] = {v->title, v->source};
  for (int k = 0; k < 2; k++) {
    if (lines[k] == NULL) continue;
    tp_encode_plain(&t, lines[k]);
    tp_text_add(&t, "\n");
  }
  tp_text_add(&t, "\n");
  for (size_t k = 0; k < v->count; k++) add_claim(&t, v->claims + k);
  tp_text_add(&t, "\n");
  tp_claims_add_tally(&t, v);
  tp_text_add(&t, "\n");
  return tp_text_finish(&t, text);
}
