/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key domain of a claims file, {a: [1, 5], b: [a, inf]}: two ends for each symbol. */

#include "verify/claims.h"
#include "verify/evaluate.h"

#include <string.h>

static tp_place text_place(const tp_claims *claims, const tp_node *node) {
  tp_place place = tp_node_place(node, claims->path);
  place.column += node->text_offset;
  return place;
}

/* One end: a formula that is rational, or no end at all. */
static tp_status read_end(fmpz_mpoly_q_t value, bool *has, const tp_claims *claims,
                          const tp_node *node, const char *none, tp_subject *subject,
                          tp_message *message) {
  *has = strcmp(node->text, none) != 0;
  if (!*has) return TP_OK;
  tp_formula formula;
  tp_status status =
      tp_subject_read(&formula, node->text, text_place(claims, node), subject, message);
  if (status != TP_OK) return status;
  bool rational = false;
  status = tp_evaluate_field(value, &rational, &formula, subject, message);
  tp_formula_clear(&formula);
  if (status != TP_OK || rational) return status;
  return tp_claims_fail(claims, node, message,
                        "the end of a domain is a number or a formula without roots, or inf");
}

static tp_status read_bounds(tp_domain *domain, const tp_claims *claims, const tp_node *node,
                             tp_domain_bounds *bounds, tp_subject *subject,
                             const tp_claim_sample *sample, tp_message *message) {
  const bool pair = node->kind == TP_NODE_SEQUENCE && node->count == 2 &&
                    node->first->kind == TP_NODE_SCALAR && node->last->kind == TP_NODE_SCALAR;
  if (!pair) {
    return tp_claims_fail(claims, node, message, "a domain is two ends: [0, 5], or [a, inf]");
  }
  tp_status status =
      read_end(bounds->low, &bounds->has_low, claims, node->first, "-inf", subject, message);
  if (status == TP_OK) {
    status = read_end(bounds->high, &bounds->has_high, claims, node->last, "inf", subject, message);
  }
  if (status != TP_OK) return status;
  return tp_domain_bound(domain, bounds, sample, tp_node_place(node, claims->path), message);
}

tp_status tp_claims_read_domain(tp_domain *domain, const tp_claims *claims, const tp_node *node,
                                bool all_names, tp_subject *subject, const tp_claim_sample *sample,
                                tp_message *message) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_MAPPING) {
    return tp_claims_fail(claims, node, message,
                          "'domain' is a map of names to their ends: {a: [0, 5], b: [a, inf]}");
  }
  const fmpz_mpoly_ctx_struct *ring = subject->field->ring;
  tp_status status = TP_OK;
  tp_domain_bounds bounds;
  fmpz_mpoly_q_init(bounds.low, ring);
  fmpz_mpoly_q_init(bounds.high, ring);
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    bounds.symbol = tp_sample_symbol(subject, n->key);
    if (bounds.symbol < 0 && !all_names) continue; /* of another geometry */
    if (bounds.symbol < 0) {
      status = tp_claims_fail(claims, n, message,
                              "'%.40s' is not a symbol that takes a value: a domain is one of "
                              "parameters, symbols, angles and r",
                              n->key);
    } else {
      status = read_bounds(domain, claims, n, &bounds, subject, sample, message);
    }
  }
  fmpz_mpoly_q_clear(bounds.low, ring);
  fmpz_mpoly_q_clear(bounds.high, ring);
  return status;
}
