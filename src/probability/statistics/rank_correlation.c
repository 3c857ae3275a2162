/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ranks by sorting with shared means for ties, Pearson's correlation of the ranks, and Fisher's
 * transformation for the interval. */

#include "statistics/rank_correlation.h"

#include "statistics/score.h"
#include "statistics/sum.h"

#include <stdlib.h>

typedef struct placed {
  double value;
  size_t place;
} placed;

static int compare(const void *left, const void *right) {
  const placed *a = left, *b = right;
  if (a->value != b->value) return a->value < b->value ? -1 : 1;
  return (a->place > b->place) - (a->place < b->place);
}

tp_status tp_ranks(double *ranks, const double *values, size_t count, tp_message *message) {
  if (count == 0) return TP_OK;
  placed *order = calloc(count, sizeof *order);
  if (order == NULL) return tp_fail_memory(message, "the ranks of samples");
  for (size_t k = 0; k < count; k++) order[k] = (placed){values[k], k};
  qsort(order, count, sizeof *order, compare);
  for (size_t k = 0; k < count;) {
    size_t end = k + 1;
    while (end < count && order[end].value == order[k].value) end++;
    const double shared = ((double)k + 1 + (double)end) / 2;
    for (; k < end; k++) ranks[order[k].place] = shared;
  }
  free(order);
  return TP_OK;
}

tp_estimate tp_rank_correlation(const double *x, const double *y, size_t count, double confidence) {
  const double n = (double)count, mean = (n + 1) / 2;
  tp_sum xx = {0}, yy = {0}, xy = {0};
  for (size_t k = 0; k < count; k++) {
    tp_sum_add(&xx, (x[k] - mean) * (x[k] - mean));
    tp_sum_add(&yy, (y[k] - mean) * (y[k] - mean));
    tp_sum_add(&xy, (x[k] - mean) * (y[k] - mean));
  }
  const double spread = sqrt(tp_sum_value(&xx)) * sqrt(tp_sum_value(&yy));
  if (!(spread > 0)) return (tp_estimate){NAN, -1, 1};
  const double r = fmax(fmin(tp_sum_value(&xy) / spread, 1), -1);
  if (count < 4) return (tp_estimate){r, -1, 1};
  const double half = tp_normal_score(confidence, 1) * sqrt((1 + r * r / 2) / (n - 3));
  return (tp_estimate){r, tanh(atanh(r) - half), tanh(atanh(r) + half)};
}
