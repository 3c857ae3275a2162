/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* For each quantity, the ranks of the samples that have it, and Spearman's correlation with every
 * input column (statistics/rank_correlation.h). */

#include "study/ranks.h"

#include "block_system/state_limits.h"
#include "statistics/rank_correlation.h"

#include <math.h>
#include <stdlib.h>

enum { FEWEST = 4 };

/* Room for the samples that have a quantity: two columns, and their ranks. */
typedef struct pairs {
  double *values, *x, *y;
} pairs;

static bool is_constant(const double *values, size_t count) {
  for (size_t k = 1; k < count; k++) {
    if (values[k] != values[0]) return false;
  }
  return true;
}

/* A quantity that differs by less than it is certain to has no order among its samples. */
static bool is_certainly_ordered(const double *quantity, size_t count, const tp_study *study) {
  const double accuracy = study->scene->many.count > 0 ? TP_LIMIT_SHARE : 1e-12; /* of itself */
  double least = INFINITY, most = -INFINITY;
  for (size_t k = 0; k < count; k++) {
    least = fmin(least, quantity[k]);
    most = fmax(most, quantity[k]);
  }
  if (!isfinite(least) || !isfinite(most)) return least != most;
  return most - least > 2 * accuracy * fmax(fabs(least), fabs(most));
}

/* Those of a column whose quantity is a number. */
static size_t pick(double *picked, const double *column, const double *quantity, size_t kept) {
  size_t count = 0;
  for (size_t k = 0; k < kept; k++) {
    if (!isnan(quantity[k])) picked[count++] = column[k];
  }
  return count;
}

/* Of the values that were picked, with the quantity whose ranks there are. */
static tp_status rank_column(tp_study_rank *rank, const pairs *p, size_t count,
                             tp_message *message) {
  for (size_t k = 0; k < count; k++) {
    if (isnan(p->values[k])) return TP_OK;
  }
  if (is_constant(p->values, count)) return TP_OK;
  const tp_status status = tp_ranks(p->x, p->values, count, message);
  if (status != TP_OK) return status;
  const tp_estimate own = tp_rank_correlation(p->x, p->y, count, 0.95);
  *rank = (tp_study_rank){true, own.value, own.low, own.high};
  return TP_OK;
}

/* Of all variables and measures with one quantity, whose ranks are taken once. */
static tp_status rank_quantity(tp_study_result *result, const tp_tally *tally, size_t q,
                               const pairs *p, tp_message *message) {
  const size_t kept = tp_tally_kept(tally), inputs = tally->study->variable_count;
  const double *quantity = tally->columns[inputs + q];
  const size_t count = pick(p->values, quantity, quantity, kept);
  if (count < FEWEST || !is_certainly_ordered(p->values, count, tally->study)) return TP_OK;
  tp_status status = tp_ranks(p->y, p->values, count, message);
  for (size_t k = 0; k < inputs && status == TP_OK; k++) {
    (void)pick(p->values, tally->columns[k], quantity, kept);
    status = rank_column(result->variables[k].rank_correlations + q, p, count, message);
  }
  for (size_t k = 0; k < tally->study->measure_count && status == TP_OK; k++) {
    (void)pick(p->values, tally->columns[tp_tally_measures(tally->study) + k], quantity, kept);
    status = rank_column(result->roughness[k].rank_correlations + q, p, count, message);
  }
  return status;
}

tp_status tp_tally_ranks(tp_study_result *result, const tp_tally *tally, tp_message *message) {
  const size_t kept = tp_tally_kept(tally);
  double *all = calloc(3 * kept + 1, sizeof *all);
  if (all == NULL) return tp_fail_memory(message, "rank correlations");
  const pairs p = {all, all + kept, all + 2 * kept};
  tp_status status = TP_OK;
  for (size_t q = 0; q < tp_study_quantity_count(tally->study) && status == TP_OK; q++) {
    status = rank_quantity(result, tally, q, &p, message);
  }
  free(all);
  return status;
}
