/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A verification as JSON: verdict, values and remark of each claim. */

#include "common/host.h"
#include "output/json.h"

/* `computed` is the closed form of a formula's quantity, or a number with its bound. */
static void add_verdict(tp_json *j, const tp_claim_result *c) {
  tp_json_break(j);
  if (c->is_formula) {
    tp_json_string(j, "computed", c->derived);
  } else {
    tp_json_bounded(j, "computed", c->computed);
  }
  tp_json_string(j, "difference", c->difference);
  tp_json_truth(j, "of_tangents", c->is_tangent);
  tp_json_string(j, "mend", c->mend);
  tp_json_string(j, "change", c->change);
}

/* Where a formula was looked at in numbers. */
static void add_values(tp_json *j, const tp_claim_result *c) {
  if (c->is_formula && c->has_values) {
    tp_json_break(j);
    tp_json_string(j, "at", c->values);
    tp_json_bounded(j, "printed_there", c->printed_value);
    tp_json_bounded(j, "computed_there", c->computed);
  }
  if (c->points > 0) {
    tp_json_integer(j, "digits", c->digits);
    tp_json_integer(j, "points", c->points);
  }
}

/* On a line of its own, where there is any. */
static void add_remark(tp_json *j, const char *key, const char *text) {
  if (text == NULL) return;
  tp_json_break(j);
  tp_json_string(j, key, text);
}

static void add_claim(tp_json *j, const tp_claim_result *c) {
  tp_json_object(j, NULL, TP_JSON_ALIGNED);
  tp_json_string(j, "id", c->id);
  tp_json_string(j, "where", c->where);
  tp_json_string(j, "verdict", tp_verdict_name(c->verdict));
  tp_json_break(j);
  tp_json_string(j, "geometry", c->geometry);
  tp_json_string(j, "quantity", c->quantity);
  tp_json_string(j, "printed", c->printed);
  tp_json_string(j, "unit", c->unit);
  add_verdict(j, c);
  add_values(j, c);
  add_remark(j, "condition", c->condition);
  add_remark(j, "note", c->note);
  tp_json_close(j);
}

tp_status tp_report_verification_json(char **text, const tp_verification *v) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, v);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_string(&j, "title", v->title);
  tp_json_string(&j, "source", v->source);
  tp_json_object(&j, "tally", TP_JSON_LINE);
  for (int k = 0; k < TP_VERDICTS; k++) {
    tp_json_count(&j, tp_verdict_name((tp_verdict)k), v->tally[k]);
  }
  tp_json_close(&j);
  tp_json_array(&j, "claims", TP_JSON_BLOCK);
  for (size_t k = 0; k < v->count; k++) add_claim(&j, v->claims + k);
  tp_json_close(&j);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
