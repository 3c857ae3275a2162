/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the list of claims: single ones, and tables whose cells become claims by row and column,
 * with unique identifiers. */

#include "verify/claims.h"

#include "common/outside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The parts that are there, with dots between: a table, a row, a column; NULL without memory. */
static char *joined(const char *const parts[3]) {
  size_t size = 1;
  for (int k = 0; k < 3 && parts[k] != NULL; k++) size += strlen(parts[k]) + 1;
  char *id = malloc(size), *end = id;
  if (id == NULL) return NULL;
  *end = '\0';
  for (int k = 0; k < 3 && parts[k] != NULL; k++) {
    if (k > 0) *end++ = '.';
    end = stpcpy(end, parts[k]);
  }
  return id;
}

static tp_status add_claim(tp_claims *claims, tp_claim claim, const char *const id[3],
                           tp_message *message) {
  if (claims->claim_count == claims->claim_capacity) {
    const long capacity = 2 * claims->claim_capacity + 64;
    tp_claim *all = realloc(claims->claims, (size_t)capacity * sizeof *all);
    if (all == NULL) return tp_fail_memory(message, "the claims");
    claims->claims = all;
    claims->claim_capacity = capacity;
  }
  claim.id = joined(id);
  if (claim.id == NULL) return tp_fail_memory(message, "the claims");
  claims->claims[claims->claim_count++] = claim;
  return TP_OK;
}

/* The geometry that a node names; NULL where there is none. */
static tp_status find_geometry(const tp_geometry **geometry, const tp_claims *claims,
                               const tp_node *node, tp_message *message) {
  const char *name = NULL;
  const tp_status status = tp_claims_text(&name, claims, node, "geometry", false, message);
  if (status != TP_OK || name == NULL) return status;
  const char **names = calloc((size_t)claims->geometry_count + 1, sizeof *names);
  if (names == NULL) return tp_fail_memory(message, "the claims");
  for (long k = 0; k < claims->geometry_count; k++) {
    names[k] = claims->geometries[k].name;
    if (strcmp(names[k], name) == 0) *geometry = claims->geometries + k;
  }
  const char *nearest = *geometry == NULL ? tp_nearest(name, names) : NULL;
  free(names);
  if (*geometry != NULL) return TP_OK;
  return tp_claims_fail(
      claims, tp_node_get(node, "geometry"), message, "no geometry is called '%s'%s%s%s",
      tp_quote_all(name).text, nearest != NULL ? "; did you mean '" : "",
      nearest != NULL ? tp_quote_all(nearest).text : "", nearest != NULL ? "'?" : "");
}

static tp_status read_scalar(const tp_node **scalar, const tp_claims *claims, const tp_node *node,
                             const char *key, tp_message *message) {
  const char *text = NULL;
  *scalar = tp_node_get(node, key);
  return tp_claims_text(&text, claims, node, key, true, message);
}

/* What a claim and a column have in common, besides `where`. */
static tp_status read_common(tp_claim *claim, const tp_claims *claims, const tp_node *node,
                             tp_message *message) {
  tp_status status = read_scalar(&claim->quantity, claims, node, "quantity", message);
  if (status == TP_OK) status = tp_claims_text(&claim->unit, claims, node, "unit", false, message);
  if (status == TP_OK) status = tp_claims_text(&claim->note, claims, node, "note", false, message);
  if (status == TP_OK) status = find_geometry(&claim->geometry, claims, node, message);
  claim->with[0] = tp_node_get(node, "with");
  claim->at[0] = tp_node_get(node, "at");
  claim->domain[0] = tp_node_get(node, "domain");
  return status;
}

static tp_status read_claim(tp_claims *claims, const tp_node *node, const char *id,
                            const char *where, tp_message *message) {
  static const char *const keys[] = {"id",   "where", "geometry", "quantity", "printed", "unit",
                                     "note", "with",  "at",       "domain",   NULL};
  tp_claim claim = {.where = where};
  tp_status status = tp_node_expect_keys(node, keys, "a claim", claims->path, message);
  if (status == TP_OK) status = read_common(&claim, claims, node, message);
  if (status == TP_OK) status = read_scalar(&claim.printed, claims, node, "printed", message);
  if (status != TP_OK) return status;
  return add_claim(claims, claim, (const char *const[3]){id}, message);
}

/* A row of a table: its cells, each a claim by its column. */
static tp_status read_row(tp_claims *claims, const tp_node *row, const tp_node *columns,
                          const tp_claim *prototypes, const char *id, tp_message *message) {
  static const char *const own[] = {"row", "geometry", "with", "at", "domain", NULL};
  const char *name = NULL, **keys = calloc((size_t)columns->count + 6, sizeof *keys);
  if (keys == NULL) return tp_fail_memory(message, "the claims");
  size_t count = 0;
  for (; own[count] != NULL; count++) keys[count] = own[count];
  for (const tp_node *c = columns->first; c != NULL; c = c->next) keys[count++] = c->key;
  tp_status status = tp_node_expect_keys(row, keys, "a row", claims->path, message);
  free(keys);
  if (status == TP_OK) status = tp_claims_text(&name, claims, row, "row", true, message);
  const tp_geometry *geometry = NULL;
  if (status == TP_OK) status = find_geometry(&geometry, claims, row, message);
  const tp_claim *prototype = prototypes;
  for (const tp_node *c = columns->first; c != NULL && status == TP_OK; c = c->next, prototype++) {
    tp_claim claim = *prototype;
    claim.printed = tp_node_get(row, c->key);
    if (claim.printed == NULL) continue; /* the table is silent here */
    if (claim.printed->kind != TP_NODE_SCALAR) {
      return tp_claims_fail(claims, claim.printed, message, "a cell is a number or a formula");
    }
    if (geometry != NULL) claim.geometry = geometry;
    claim.with[1] = tp_node_get(row, "with");
    claim.at[1] = tp_node_get(row, "at");
    claim.domain[1] = tp_node_get(row, "domain");
    status = add_claim(claims, claim, (const char *const[3]){id, name, c->key}, message);
  }
  return status;
}

static tp_status read_table(tp_claims *claims, const tp_node *node, const char *id,
                            const char *where, tp_message *message) {
  static const char *const keys[] = {"id", "where", "columns", "rows", NULL},
                           *const column_keys[] = {"quantity", "unit", "note",   "geometry",
                                                   "with",     "at",   "domain", NULL};
  const tp_node *columns = tp_node_get(node, "columns"), *rows = tp_node_get(node, "rows");
  tp_status status = tp_node_expect_keys(node, keys, "a table", claims->path, message);
  if (status != TP_OK) return status;
  if (columns == NULL || columns->kind != TP_NODE_MAPPING || rows->kind != TP_NODE_SEQUENCE) {
    return tp_claims_fail(claims, node, message,
                          "a table has 'columns', a map of names to {quantity: …}, and a list of "
                          "'rows'");
  }
  tp_claim *prototypes = calloc((size_t)columns->count + 1, sizeof *prototypes);
  if (prototypes == NULL) return tp_fail_memory(message, "the claims");
  tp_claim *prototype = prototypes;
  for (const tp_node *c = columns->first; c != NULL && status == TP_OK; c = c->next, prototype++) {
    prototype->where = where;
    status = tp_node_expect_keys(c, column_keys, "a column", claims->path, message);
    if (status == TP_OK) status = read_common(prototype, claims, c, message);
  }
  for (const tp_node *r = rows->first; r != NULL && status == TP_OK; r = r->next) {
    status = read_row(claims, r, columns, prototypes, id, message);
  }
  free(prototypes);
  return status;
}

static int by_id(const void *a, const void *b) {
  return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Refuse an identifier that is given twice. */
static tp_status check_ids(const tp_claims *claims, const tp_node *list, tp_message *message) {
  const size_t count = (size_t)claims->claim_count;
  const char **ids = calloc(count + 1, sizeof *ids);
  if (ids == NULL) return tp_fail_memory(message, "the claims");
  for (size_t k = 0; k < count; k++) ids[k] = claims->claims[k].id;
  qsort(ids, count, sizeof *ids, by_id);
  tp_status status = TP_OK;
  for (size_t k = 1; k < count && status == TP_OK; k++) {
    if (strcmp(ids[k - 1], ids[k]) != 0) continue;
    const tp_node *at = list;
    for (size_t j = count; j-- > 0 && at == list;) {
      if (strcmp(claims->claims[j].id, ids[k]) == 0) at = claims->claims[j].printed;
    }
    status = tp_claims_fail(claims, at, message, "the claim '%s' is given twice",
                            tp_quote_all(ids[k]).text);
  }
  free(ids);
  return status;
}

tp_status tp_claims_read_list(tp_claims *claims, const tp_node *list, tp_message *message) {
  tp_status status = TP_OK;
  for (const tp_node *node = list->first; node != NULL && status == TP_OK; node = node->next) {
    const char *id = NULL, *where = NULL;
    if (node->kind != TP_NODE_MAPPING) {
      return tp_claims_fail(claims, node, message,
                            "a claim is a map: {id: …, where: …, quantity: …, printed: …}");
    }
    status = tp_claims_text(&id, claims, node, "id", true, message);
    if (status == TP_OK) status = tp_claims_text(&where, claims, node, "where", true, message);
    if (status != TP_OK) break;
    status = tp_node_get(node, "rows") != NULL ? read_table(claims, node, id, where, message)
                                               : read_claim(claims, node, id, where, message);
  }
  return status == TP_OK ? check_ids(claims, list, message) : status;
}
