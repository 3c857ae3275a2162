/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads one variable: parameters of a distribution by a table of laws, lists, grids and columns,
 * then its truncation. */

#include "study/variable.h"

#include "common/outside.h"
#include "study/column.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- distributions by parameters ---------------------------------------------------------------
 */

enum { PARAMETERS = 4 };

/* Its keys in the file, with an example, and how it is made of their numbers. */
typedef struct law {
  const char *name, *keys[PARAMETERS + 1], *example;
  tp_distribution (*make)(const double *numbers);
} law;

static tp_distribution make_uniform(const double *n) {
  return tp_distribution_uniform(n[0], n[1]);
}

static tp_distribution make_normal(const double *n) {
  return tp_distribution_normal(n[0], n[1]);
}

static tp_distribution make_lognormal(const double *n) {
  return tp_distribution_lognormal(n[0], n[1]);
}

static tp_distribution make_triangular(const double *n) {
  return tp_distribution_triangular(n[0], n[1], n[2]);
}

static tp_distribution make_beta(const double *n) {
  return tp_distribution_beta(n[0], n[1], n[2], n[3]);
}

static const law laws[] = {
    {"uniform", {"low", "high", NULL}, "uniform: {low: 25, high: 35}", make_uniform},
    {"normal", {"mean", "deviation", NULL}, "normal: {mean: 30, deviation: 2}", make_normal},
    {"lognormal",
     {"mean", "deviation", NULL},
     "lognormal: {mean: 30, deviation: 2}",
     make_lognormal},
    {"triangular",
     {"low", "mode", "high", NULL},
     "triangular: {low: 0, mode: 0.05, high: 0.2}",
     make_triangular},
    {"beta", {"a", "b", "low", "high", NULL}, "beta: {a: 2, b: 3, low: 25, high: 35}", make_beta},
};
enum { LAWS = sizeof laws / sizeof laws[0] };

static tp_status read_law(const tp_study_reader *reader, tp_variable *variable, const law *own,
                          const tp_node *node) {
  double numbers[PARAMETERS] = {0};
  tp_status status =
      tp_node_expect_keys(node, own->keys, own->name, reader->study->path, reader->message);
  for (size_t k = 0; own->keys[k] != NULL && status == TP_OK; k++) {
    const tp_node *child = tp_node_get(node, own->keys[k]);
    status = child != NULL ? tp_study_read_number(reader, numbers + k, child, own->keys[k])
                           : tp_study_fail(reader, node, "'%s' is missing here, for example '%s'",
                                           own->keys[k], own->example);
  }
  if (status == TP_OK) variable->distribution = own->make(numbers);
  return status;
}

/* ---- lists, grids, columns ---------------------------------------------------------------------
 */

static tp_status room_for(const tp_study_reader *reader, tp_variable *variable, size_t count) {
  variable->values = calloc(count, sizeof *variable->values);
  if (variable->values == NULL) return tp_fail_memory(reader->message, "the numbers of a study");
  variable->count = count;
  return TP_OK;
}

static tp_status read_list(const tp_study_reader *reader, tp_variable *variable,
                           const tp_node *node) {
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > TP_STUDY_LISTED) {
    return tp_study_fail(reader, node, "a list holds numbers, as in 'list: [1, 2, 3]'");
  }
  tp_status status = room_for(reader, variable, (size_t)node->count);
  size_t k = 0;
  for (const tp_node *own = node->first; own != NULL && status == TP_OK; own = own->next) {
    status = tp_study_read_number(reader, variable->values + k++, own, "list");
  }
  return status;
}

/* from, from + step, ... up to and with `to`, each exact before it is rounded. */
static tp_status fill_grid(const tp_study_reader *reader, tp_variable *variable, fmpq *n,
                           const tp_node *node) {
  fmpq_t steps;
  fmpz_t whole;
  fmpq_init(steps);
  fmpz_init(whole);
  tp_status status = TP_OK;
  const bool moves = !fmpq_is_zero(n + 2);
  if (moves) {
    fmpq_sub(steps, n + 1, n);
    fmpq_div(steps, steps, n + 2);
    fmpz_fdiv_q(whole, fmpq_numref(steps), fmpq_denref(steps));
  }
  if (!moves || fmpz_sgn(whole) < 0 || fmpz_cmp_si(whole, TP_STUDY_LISTED) >= 0) {
    status = tp_study_fail(reader, node,
                           "the steps lead from 'from' to 'to', a million at most, as in 'grid: "
                           "{from: 0, to: 10, step: 2}'");
  } else {
    status = room_for(reader, variable, (size_t)fmpz_get_si(whole) + 1);
  }
  for (size_t k = 0; k < variable->count && status == TP_OK; k++) {
    variable->values[k] = tp_study_double(n);
    fmpq_add(n, n, n + 2);
  }
  fmpz_clear(whole);
  fmpq_clear(steps);
  return status;
}

static tp_status read_grid(const tp_study_reader *reader, tp_variable *variable,
                           const tp_node *node) {
  static const char *const keys[] = {"from", "to", "step", NULL};
  fmpq numbers[3];
  tp_status status = tp_node_expect_keys(node, keys, "grid", reader->study->path, reader->message);
  for (size_t k = 0; k < 3; k++) fmpq_init(numbers + k);
  for (size_t k = 0; keys[k] != NULL && status == TP_OK; k++) {
    const tp_node *child = tp_node_get(node, keys[k]);
    status = child != NULL ? tp_study_read_exact(reader, numbers + k, child, keys[k])
                           : tp_study_fail(reader, node, "'%s' is missing here, for example '%s'",
                                           keys[k], "grid: {from: 0, to: 10, step: 2}");
  }
  if (status == TP_OK) status = fill_grid(reader, variable, numbers, node);
  for (size_t k = 0; k < 3; k++) fmpq_clear(numbers + k);
  return status;
}

static int by_size(const void *one, const void *other) {
  const double a = *(const double *)one, b = *(const double *)other;
  return (a > b) - (a < b);
}

static tp_status read_empirical(const tp_study_reader *reader, tp_variable *variable,
                                const tp_node *node) {
  const tp_status status = tp_study_read_column(reader, variable, node);
  if (status != TP_OK) return status;
  qsort(variable->values, variable->count, sizeof *variable->values, by_size);
  variable->distribution = tp_distribution_empirical(variable->values, variable->count);
  return TP_OK;
}

/* ---- one of them -------------------------------------------------------------------------------
 */

static const char *const kinds[] = {"uniform", "normal",    "lognormal", "triangular",
                                    "beta",    "empirical", "list",      "grid",
                                    "column",  "truncated", NULL};
static const char example[] = "{normal: {mean: 30, deviation: 2}}";

static tp_status read_kind(const tp_study_reader *reader, tp_variable *variable,
                           const tp_node *node) {
  const char *name = node->key;
  for (size_t k = 0; k < LAWS; k++) {
    if (strcmp(name, laws[k].name) != 0) continue;
    variable->kind = laws[k].name;
    return read_law(reader, variable, laws + k, node);
  }
  if (strcmp(name, "empirical") == 0) {
    variable->kind = "empirical";
    return read_empirical(reader, variable, node);
  }
  variable->source = TP_VARIABLE_LISTED;
  if (strcmp(name, "list") == 0) {
    variable->kind = "list";
    return read_list(reader, variable, node);
  }
  if (strcmp(name, "grid") == 0) {
    variable->kind = "grid";
    return read_grid(reader, variable, node);
  }
  variable->kind = "column";
  variable->source = TP_VARIABLE_COLUMN;
  return tp_study_read_column(reader, variable, node);
}

/* [low, high], of which either may be .inf or -.inf. */
static tp_status read_end(const tp_study_reader *reader, double *end, const tp_node *node) {
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, ".inf") == 0) {
    *end = INFINITY;
  } else if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "-.inf") == 0) {
    *end = -INFINITY;
  } else {
    return tp_study_read_number(reader, end, node, "truncated");
  }
  return TP_OK;
}

static tp_status truncate_it(const tp_study_reader *reader, tp_variable *variable,
                             const tp_node *node) {
  double low = 0, high = 0;
  if (variable->source != TP_VARIABLE_DRAWN) {
    return tp_study_fail(reader, node,
                         "a %s is not a distribution, and cannot be truncated; leave "
                         "out the values that are not wanted",
                         variable->kind);
  }
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_study_fail(reader, node,
                         "a truncation is [low, high], as in 'truncated: [20, 40]' "
                         "or '[0, .inf]'");
  }
  tp_status status = read_end(reader, &low, node->first);
  if (status == TP_OK) status = read_end(reader, &high, node->last);
  if (status == TP_OK) {
    variable->distribution = tp_distribution_truncated(variable->distribution, low, high);
  }
  return status;
}

tp_status tp_variable_read(const tp_study_reader *reader, tp_variable *variable,
                           const tp_node *node) {
  const tp_node *of = NULL;
  tp_status status = tp_node_expect_keys(node, kinds, tp_quote_all(node->key).text,
                                         reader->study->path, reader->message);
  variable->node = node;
  for (const tp_node *child = node->first; child != NULL && status == TP_OK; child = child->next) {
    if (strcmp(child->key, "truncated") == 0) continue;
    if (of != NULL) {
      status = tp_study_fail(reader, child, "'%s' varies by '%s' already; give only one of them",
                             tp_quote_all(node->key).text, of->key);
    }
    of = child;
  }
  if (status != TP_OK) return status;
  if (of == NULL) {
    return tp_study_fail(reader, node, "give the distribution of '%s', for example %s",
                         tp_quote_all(node->key).text, example);
  }
  status = read_kind(reader, variable, of);
  const tp_node *truncated = tp_node_get(node, "truncated");
  if (status == TP_OK && truncated != NULL) status = truncate_it(reader, variable, truncated);
  if (status != TP_OK || variable->source != TP_VARIABLE_DRAWN) return status;
  return tp_distribution_check(&variable->distribution, node->key,
                               tp_node_place(of, reader->study->path), reader->message);
}

void tp_variable_clear(tp_variable *variable) {
  free(variable->values);
  free(variable->file);
}
