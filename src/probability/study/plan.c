/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads method, seed, chunk, samples and correlations, and checks the plan as a whole. */

#include "study/plan.h"

#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

enum { CHUNK_MOST = 100000 };

static tp_status read_method(const tp_study_reader *reader, const tp_node *node) {
  enum { METHODS = TP_DRAW_SOBOL + 1 };
  const char *known[METHODS + 1] = {NULL};
  for (int k = 0; k < METHODS; k++) {
    known[k] = tp_draw_method_name((tp_draw_method)k);
    if (node->kind != TP_NODE_SCALAR || strcmp(node->text, known[k]) != 0) continue;
    reader->study->method = (tp_draw_method)k;
    return TP_OK;
  }
  const char *nearest = node->kind == TP_NODE_SCALAR ? tp_nearest(node->text, known) : NULL;
  return tp_study_fail(reader, node, "a method is %s, %s or %s%s%s%s", known[0], known[1], known[2],
                       nearest != NULL ? "; did you mean '" : "", nearest != NULL ? nearest : "",
                       nearest != NULL ? "'?" : "");
}

static tp_status read_sampling(const tp_study_reader *reader, const tp_node *root) {
  static const char *const keys[] = {"method", "seed", "chunk", NULL};
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "sampling");
  if (node == NULL) return TP_OK;
  tp_status status = tp_node_expect_keys(node, keys, "sampling", study->path, reader->message);
  const tp_node *method = tp_node_get(node, "method"), *seed = tp_node_get(node, "seed"),
                *chunk = tp_node_get(node, "chunk");
  if (status == TP_OK && method != NULL) status = read_method(reader, method);
  if (status == TP_OK && seed != NULL) {
    status = tp_study_read_whole(reader, &study->seed, seed, "seed", 0, INT64_MAX);
  }
  if (status == TP_OK && chunk != NULL) {
    uint64_t size = 0;
    status = tp_study_read_whole(reader, &size, chunk, "chunk", 1, CHUNK_MOST);
    if (status == TP_OK) study->chunk = (size_t)size;
  }
  return status;
}

static tp_status read_samples(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "samples");
  uint64_t samples = 1;
  if (study->drawn == 0 && node != NULL) {
    return tp_study_fail(reader, node,
                         "lists, grids and columns fix the number of samples, and "
                         "nothing is drawn; leave 'samples' out");
  }
  if (study->drawn > 0 && node == NULL) {
    return tp_study_fail(reader, root, "'samples' is missing, for example 'samples: 10000'");
  }
  tp_status status = TP_OK;
  if (node != NULL) {
    status =
        tp_study_read_whole(reader, &samples, node, "samples", 1, TP_STUDY_SAMPLES / study->cells);
  }
  study->samples = samples * study->cells;
  return status;
}

/* ---- correlations ------------------------------------------------------------------------------
 */

/* The dimension of a variable that is drawn. */
static tp_status find_drawn(const tp_study_reader *reader, size_t *dimension, const tp_node *node) {
  const tp_study *study = reader->study;
  const char *known[TP_STUDY_VARIABLES + 1] = {NULL};
  if (node->kind != TP_NODE_SCALAR) {
    return tp_study_fail(reader, node, "this is to be a key that is drawn");
  }
  for (size_t k = 0; k < study->drawn; k++) {
    known[k] = study->drawn_names[k];
    *dimension = k;
    if (strcmp(node->text, known[k]) == 0) return TP_OK;
  }
  const char *nearest = tp_nearest(node->text, known);
  return tp_study_fail(reader, node, "'%s' is not drawn from a distribution%s%s%s",
                       tp_quote_all(node->text).text, nearest != NULL ? "; did you mean '" : "",
                       nearest != NULL ? tp_quote_all(nearest).text : "",
                       nearest != NULL ? "'?" : "");
}

static tp_status read_pair(const tp_study_reader *reader, const tp_node *node) {
  size_t one = 0, other = 0;
  double value = 0;
  tp_study *study = reader->study;
  if (node->kind != TP_NODE_SEQUENCE || node->count != 3) {
    return tp_study_fail(reader, node, "a correlation is [KEY, KEY, NUMBER]");
  }
  tp_status status = find_drawn(reader, &one, node->first);
  if (status == TP_OK) status = find_drawn(reader, &other, node->first->next);
  if (status == TP_OK) status = tp_study_read_number(reader, &value, node->last, "correlations");
  if (status != TP_OK) return status;
  double *matrix = study->correlation;
  if (one == other || matrix[one * study->drawn + other] != 0) {
    return tp_study_fail(reader, node,
                         one == other ? "a number has correlation 1 with itself"
                                      : "this pair was given above");
  }
  matrix[one * study->drawn + other] = matrix[other * study->drawn + one] = value;
  return TP_OK;
}

static tp_status read_correlations(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "correlations");
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_study_fail(reader, node, "correlations are a list of [KEY, KEY, NUMBER]");
  }
  study->correlation = calloc(study->drawn * study->drawn + 1, sizeof *study->correlation);
  if (study->correlation == NULL) return tp_fail_memory(reader->message, "the correlations");
  for (size_t k = 0; k < study->drawn; k++) study->correlation[k * study->drawn + k] = 1;
  tp_status status = TP_OK;
  for (const tp_node *own = node->first; own != NULL && status == TP_OK; own = own->next) {
    status = read_pair(reader, own);
  }
  return status;
}

/* The draws as a whole can be had: their counts, and the matrix of correlations is one. */
static tp_status check_draws(const tp_study_reader *reader, const tp_node *root) {
  const tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "correlations");
  if (study->drawn == 0) return TP_OK;
  const tp_draws draws = {study->method, study->seed,       study->samples / study->cells, 1,
                          study->drawn,  study->correlation};
  tp_draws_walk *walk = NULL;
  tp_message inner = {.text = ""};
  const tp_status status = tp_draws_begin(&walk, &draws, 0, study->drawn_names, &inner);
  tp_draws_end(walk);
  return status == TP_OK ? TP_OK
                         : tp_study_fail_of(reader, node != NULL ? node : root, status, &inner);
}

tp_status tp_study_read_plan(const tp_study_reader *reader, const tp_node *root) {
  tp_status status = read_sampling(reader, root);
  if (status == TP_OK) status = read_samples(reader, root);
  if (status == TP_OK) status = read_correlations(reader, root);
  return status == TP_OK ? check_draws(reader, root) : status;
}
