/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A verification as JSON. */

#include "host.h"
#include "output/json.h"

static void add_text(tp_text *t, const char *key, const char *text) {
  tp_text_add(t, "\"%s\": ", key);
  if (text != NULL) {
    tp_encode_json(t, text);
  } else {
    tp_text_add(t, "null");
  }
}

/* `computed` is the closed form of a formula's quantity, or a number with its bound. */
static void add_claim(tp_text *t, const tp_claim_result *c) {
  tp_text_add(t, "    {");
  add_text(t, "id", c->id);
  tp_text_add(t, ", ");
  add_text(t, "where", c->where);
  tp_text_add(t, ", \"verdict\": \"%s\",\n     ", tp_verdict_name(c->verdict));
  add_text(t, "geometry", c->geometry);
  tp_text_add(t, ", ");
  add_text(t, "quantity", c->quantity);
  tp_text_add(t, ", ");
  add_text(t, "printed", c->printed);
  tp_text_add(t, ", ");
  add_text(t, "unit", c->unit);
  tp_text_add(t, ",\n     ");
  if (c->is_formula) {
    add_text(t, "computed", c->derived);
  } else {
    tp_json_number(t, "computed", c->computed);
  }
  tp_text_add(t, ", ");
  add_text(t, "difference", c->difference);
  tp_text_add(t, ", \"of_tangents\": %s, ", tp_json_truth(c->is_tangent));
  add_text(t, "mend", c->mend);
  tp_text_add(t, ", ");
  add_text(t, "change", c->change);
  if (c->is_formula && c->has_values) {
    tp_text_add(t, ",\n     ");
    add_text(t, "at", c->values);
    tp_text_add(t, ", ");
    tp_json_number(t, "printed_there", c->printed_value);
    tp_text_add(t, ", ");
    tp_json_number(t, "computed_there", c->computed);
  }
  if (c->points > 0) tp_text_add(t, ", \"digits\": %d, \"points\": %d", c->digits, c->points);
  if (c->condition != NULL) {
    tp_text_add(t, ",\n     ");
    add_text(t, "condition", c->condition);
  }
  if (c->note != NULL) {
    tp_text_add(t, ",\n     ");
    add_text(t, "note", c->note);
  }
  tp_text_add(t, "}");
}

tp_status tp_report_verification_json(char **text, const tp_verification *v) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, v);
  tp_text t = {0};
  tp_text_add(&t, "{\n  \"topple\": \"%s\",\n  ", TP_VERSION);
  add_text(&t, "title", v->title);
  tp_text_add(&t, ",\n  ");
  add_text(&t, "source", v->source);
  tp_text_add(&t, ",\n  \"tally\": {");
  for (int k = 0; k < TP_VERDICTS; k++) {
    tp_text_add(&t, "%s\"%s\": %zu", k > 0 ? ", " : "", tp_verdict_name((tp_verdict)k),
                v->tally[k]);
  }
  tp_text_add(&t, "},\n  \"claims\": [\n");
  for (size_t k = 0; k < v->count; k++) {
    add_claim(&t, v->claims + k);
    tp_text_add(&t, "%s\n", k + 1 < v->count ? "," : "");
  }
  tp_text_add(&t, "  ]\n}\n");
  return tp_text_finish(&t, text);
}
