/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public call that judges a claims file: a subject for each geometry, the names and values of each
 * claim, and its verdict by verify/decide.h (docs/verify.md). */

#include "common/host.h"
#include "derive/field_work.h"
#include "verify/claims.h"
#include "verify/decide.h"
#include "verify/domain.h"

#include <stdlib.h>
#include <string.h>

bool tp_verification_objects(const tp_verification *v) {
  return v == NULL || v->tally[TP_VERDICT_REFUTED] + v->tally[TP_VERDICT_DISAGREES] > 0;
}

void tp_verification_free(tp_verification *v) {
  if (v == NULL) return;
  for (size_t k = 0; k < v->count; k++) {
    tp_claim_result *c = v->claims + k;
    char *const texts[] = {c->id,     c->where, c->geometry, c->quantity,   c->printed,
                           c->unit,   c->note,  c->computed, c->difference, c->mend,
                           c->change, c->at,    c->condition};
    for (size_t j = 0; j < sizeof texts / sizeof texts[0]; j++) free(texts[j]);
  }
  free(v->claims);
  free(v->title);
  free(v->source);
  free(v);
}

/* Copies a text that may be missing. */
static bool copy(char **to, const char *from) {
  *to = from != NULL ? strdup(from) : NULL;
  return from == NULL || *to != NULL;
}

/* What the verification of a file takes: a subject for each geometry, made when it is first asked
 * for, and one for claims without a block. */
typedef struct work {
  tp_claims claims;
  tp_subject *subjects;
  bool *made;
  double spent; /* units of work, of the budget for the whole file */
  tp_message *message;
} work;

static tp_status find_subject(tp_subject **subject, work *w, const tp_claim *claim) {
  const tp_geometry *g = claim->geometry;
  const long k = g != NULL ? g - w->claims.geometries : w->claims.geometry_count;
  if (!w->made[k]) {
    const tp_subject_options none = {.declared_count = w->claims.declared_count,
                                     .declared = w->claims.declared};
    const tp_place place = g != NULL ? g->place : tp_node_place(w->claims.root, w->claims.path);
    const tp_status status =
        tp_subject_init(w->subjects + k, g != NULL ? &g->options : &none, place, w->message);
    if (status != TP_OK) return status;
    w->made[k] = true;
  }
  *subject = w->subjects + k;
  return TP_OK;
}

static tp_place text_place(const work *w, const tp_node *node) {
  tp_place place = tp_node_place(node, w->claims.path);
  place.column += node->text_offset;
  return place;
}

/* The names under a `with`. */
static tp_status define(work *w, tp_subject *subject, const tp_node *with) {
  if (with == NULL) return TP_OK;
  if (with->kind != TP_NODE_MAPPING) {
    return tp_claims_fail(&w->claims, with, w->message,
                          "'with' is a map of names to formulas: {delta: 90 - i}");
  }
  tp_status status = TP_OK;
  for (const tp_node *n = with->first; n != NULL && status == TP_OK; n = n->next) {
    if (n->kind != TP_NODE_SCALAR) {
      return tp_claims_fail(&w->claims, n, w->message, "a definition is a formula");
    }
    status = tp_subject_define(subject, n->key, n->text, text_place(w, n), w->message);
  }
  return status;
}

/* The values under an `at`. */
static tp_status set_values(work *w, tp_claim_sample *sample, const tp_subject *subject,
                            const tp_node *at) {
  if (at == NULL) return TP_OK;
  if (at->kind != TP_NODE_MAPPING) {
    return tp_claims_fail(&w->claims, at, w->message,
                          "'at' is a map of names to values: {alpha: 20}");
  }
  tp_status status = TP_OK;
  fmpq_t value;
  fmpq_init(value);
  for (const tp_node *n = at->first; n != NULL && status == TP_OK; n = n->next) {
    if (n->kind != TP_NODE_SCALAR) {
      status = tp_claims_fail(&w->claims, n, w->message, "a value is a number");
      break;
    }
    status = tp_expression_evaluate(value, n->text, text_place(w, n), subject->field->parameters,
                                    w->message);
    if (status == TP_OK) {
      status = tp_sample_set(sample, subject, n->key, value, tp_node_place(n, w->claims.path),
                             w->message);
    }
  }
  fmpq_clear(value);
  return status;
}

static tp_status decide(work *w, tp_claim_result *result, const tp_claim *claim,
                        tp_subject *subject, const tp_claim_sample *sample) {
  tp_formula quantity, printed = {0};
  tp_status status = tp_subject_read(&quantity, claim->quantity->text,
                                     text_place(w, claim->quantity), subject, w->message);
  if (status != TP_OK) return status;
  tp_question question = {.subject = subject,
                          .quantity = &quantity,
                          .number = claim->printed->text,
                          .number_place = text_place(w, claim->printed),
                          .sample = sample,
                          .message = w->message};
  result->is_formula = !tp_decide_is_number(claim->printed->text);
  if (result->is_formula) {
    status =
        tp_subject_read(&printed, claim->printed->text, question.number_place, subject, w->message);
    question.printed = &printed;
    if (status == TP_OK) status = tp_decide_formula(result, &question);
    tp_formula_clear(&printed);
  } else {
    status = tp_decide_number(result, &question);
  }
  tp_formula_clear(&quantity);
  return status;
}

static tp_status decide_claim(work *w, tp_claim_result *result, const tp_claim *claim) {
  if (!copy(&result->id, claim->id) || !copy(&result->where, claim->where) ||
      !copy(&result->geometry, claim->geometry != NULL ? claim->geometry->name : NULL) ||
      !copy(&result->quantity, claim->quantity->text) ||
      !copy(&result->printed, claim->printed->text) || !copy(&result->unit, claim->unit) ||
      !copy(&result->note, claim->note)) {
    return tp_fail_memory(w->message, "the verdicts");
  }
  tp_subject *subject = NULL;
  tp_claim_sample sample = {0};
  tp_status status = find_subject(&subject, w, claim);
  if (status != TP_OK) return status;
  subject->field->work->spent = w->spent;
  status = define(w, subject, w->claims.with);
  for (int k = 0; k < 2 && status == TP_OK; k++) status = define(w, subject, claim->with[k]);
  if (status == TP_OK && !tp_sample_init(&sample, subject)) {
    status = tp_fail_memory(w->message, "the verdicts");
  }
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    status = set_values(w, &sample, subject, claim->at[k]);
  }
  if (status == TP_OK) {
    subject->domain = tp_domain_new(subject, &sample);
    if (subject->domain == NULL) status = tp_fail_memory(w->message, "the verdicts");
  }
  const tp_node *const domains[3] = {w->claims.domain, claim->domain[0], claim->domain[1]};
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status = tp_claims_read_domain(subject->domain, &w->claims, domains[k], k > 0, subject, &sample,
                                   w->message);
  }
  if (status == TP_OK) status = decide(w, result, claim, subject, &sample);
  w->spent = subject->field->work->spent;
  tp_domain_free(subject->domain);
  subject->domain = NULL;
  tp_sample_clear(&sample);
  tp_subject_forget(subject);
  return status;
}

static tp_status decide_all(work *w, tp_verification *v) {
  v->claims = calloc((size_t)w->claims.claim_count, sizeof *v->claims);
  if (v->claims == NULL || !copy(&v->title, w->claims.title) ||
      !copy(&v->source, w->claims.source)) {
    return tp_fail_memory(w->message, "the verdicts");
  }
  tp_status status = TP_OK;
  for (long k = 0; k < w->claims.claim_count && status == TP_OK; k++) {
    status = decide_claim(w, v->claims + v->count++, w->claims.claims + k);
    if (status == TP_OK) v->tally[v->claims[k].verdict]++;
  }
  return status;
}

static tp_status verify(tp_verification *v, work *w, const char *path, const char *text) {
  tp_status status = tp_claims_read(&w->claims, path, text, w->message);
  if (status != TP_OK) return status;
  const size_t count = (size_t)w->claims.geometry_count + 1;
  w->subjects = calloc(count, sizeof *w->subjects);
  w->made = calloc(count, sizeof *w->made);
  status = w->subjects != NULL && w->made != NULL ? decide_all(w, v)
                                                  : tp_fail_memory(w->message, "the verdicts");
  for (size_t k = 0; w->made != NULL && k < count; k++) {
    if (w->made[k]) tp_subject_clear(w->subjects + k);
  }
  free(w->subjects);
  free(w->made);
  tp_claims_clear(&w->claims);
  return status;
}

static tp_status start(tp_verification **verification, const char *path, const char *text,
                       tp_message *message) {
  tp_verification *v = calloc(1, sizeof *v);
  if (v == NULL) return tp_fail_memory(message, "the verdicts");
  v->size = sizeof *v;
  work w = {.message = message};
  const tp_status status = verify(v, &w, path, text);
  if (status == TP_OK) {
    *verification = v;
  } else {
    tp_verification_free(v);
  }
  return status;
}

tp_status tp_verify(tp_verification **verification, const char *path, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, verification);
  TP_REFUSE_NULL(message, path);
  return start(verification, path, NULL, message);
}

tp_status tp_verify_text(tp_verification **verification, const char *text, const char *name,
                         tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, verification);
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, name);
  return start(verification, name, text, message);
}
