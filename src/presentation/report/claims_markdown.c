/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A verification as a page in Markdown: first what is refuted, disagrees or is cut off, then all.
 */

#include "common/host.h"
#include "report/claims.h"

#include "output/encode.h"

static void add_formula(tp_text *t, const char *what, const char *formula) {
  if (formula == NULL) return;
  tp_text_add(t, "- %s: ", what);
  tp_encode_markdown_code(t, formula);
  tp_text_add(t, "\n");
}

static void add_objection(tp_text *t, const tp_claim_result *c) {
  char one[TP_NUMBER_SIZE], other[TP_NUMBER_SIZE];
  tp_text_add(t, "### ");
  tp_encode_markdown(t, c->id);
  tp_text_add(t, ": ");
  tp_encode_markdown(t, c->where);
  tp_text_add(t, ", %s\n\n", tp_verdict_name(c->verdict));
  if (c->is_formula) {
    add_formula(t, "printed", c->printed);
    add_formula(t, c->of_tangents ? "derived, its tangent" : "derived", c->computed);
    add_formula(t, c->of_tangents ? "difference of the tangents" : "difference", c->difference);
    if (c->has_values) {
      tp_text_add(t, "- at ");
      tp_encode_markdown(t, c->at);
      tp_text_add(t, ": %s as printed, %s as derived\n", tp_claim_number(one, c, c->printed_there),
                  tp_claim_number(other, c, c->computed_there));
    }
    add_formula(t, "mended", c->mend);
    if (c->change != NULL) {
      tp_text_add(t, "- the change: ");
      tp_encode_markdown(t, c->change);
      tp_text_add(t, "\n");
    }
  } else {
    tp_text_add(t, "- ");
    tp_claim_add_outcome(t, c, TP_CLAIM_MARKDOWN);
    tp_text_add(t, "\n");
    add_formula(t, "quantity", c->quantity);
  }
  if (c->condition != NULL) {
    tp_text_add(t, "- ");
    tp_encode_markdown(t, c->condition);
    tp_text_add(t, "\n");
  }
  if (c->note != NULL) {
    tp_text_add(t, "- note: ");
    tp_encode_markdown(t, c->note);
    tp_text_add(t, "\n");
  }
  tp_text_add(t, "\n");
}

static void add_row(tp_text *t, const tp_claim_result *c) {
  tp_text_add(t, "| ");
  tp_encode_markdown(t, c->id);
  tp_text_add(t, " | ");
  tp_encode_markdown(t, c->where);
  tp_text_add(t, " | %s | ", tp_verdict_name(c->verdict));
  if (c->is_formula) {
    tp_encode_markdown_code(t, c->printed);
    if (c->points > 0) tp_text_add(t, ", to %d digits at %d points", c->digits, c->points);
    if (c->condition != NULL) {
      tp_text_add(t, "; ");
      tp_encode_markdown(t, c->condition);
    }
  } else {
    tp_claim_add_outcome(t, c, TP_CLAIM_MARKDOWN);
  }
  tp_text_add(t, " |\n");
}

tp_status tp_report_verification_markdown(char **text, const tp_verification *v) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, v);
  tp_text t = {0};
  tp_text_add(&t, "# ");
  tp_encode_markdown(&t, v->title != NULL ? v->title : "Claims");
  tp_text_add(&t, "\n\n");
  if (v->source != NULL) {
    tp_encode_markdown(&t, v->source);
    tp_text_add(&t, "\n\n");
  }
  tp_claims_add_tally(&t, v);
  tp_text_add(&t, ".\n\n");
  if (tp_verification_objects(v)) tp_text_add(&t, "## Refuted, or disagreeing\n\n");
  for (size_t k = 0; k < v->count; k++) {
    if (tp_claim_objects(v->claims + k)) add_objection(&t, v->claims + k);
  }
  tp_text_add(&t, "## All claims\n\n| claim | where | verdict | |\n|---|---|---|---|\n");
  for (size_t k = 0; k < v->count; k++) add_row(&t, v->claims + k);
  return tp_text_finish(&t, text);
}
