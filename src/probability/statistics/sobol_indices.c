/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Design points A, B and AB_i, sums of the two estimators about the mean, and percentile intervals
 * from bootstrap resamples. */

#include "statistics/sobol_indices.h"

#include "generate/random.h"
#include "statistics/quantiles.h"
#include "statistics/sum.h"

#include <stdlib.h>
#include <string.h>

void tp_sobol_design_point(double *point, const double *pair, size_t dimensions, size_t which) {
  memcpy(point, which == 1 ? pair + dimensions : pair, dimensions * sizeof *point);
  if (which >= 2) point[which - 2] = pair[dimensions + which - 2];
}

/* The sums of one resample; of each variable sum (AB - A), sum B (AB - A), sum (AB - A)^2. */
typedef struct sums {
  double both, squares;
  double *apart, *product, *apart_square;
} sums;

static void clear(sums *s, size_t dimensions) {
  s->both = s->squares = 0;
  memset(s->apart, 0, 3 * dimensions * sizeof *s->apart);
}

/* `row` is of results about a number near their mean. */
static void add(sums *s, const double *row, double about, size_t dimensions) {
  const double a = row[0] - about, b = row[1] - about;
  s->both += a + b;
  s->squares += a * a + b * b;
  for (size_t i = 0; i < dimensions; i++) {
    const double apart = row[2 + i] - row[0];
    s->apart[i] += apart;
    s->product[i] += b * apart;
    s->apart_square[i] += apart * apart;
  }
}

/* first[i] and total[i]; false where nothing varies. */
static bool indices_of(double *first, double *total, size_t stride, const sums *s, size_t samples,
                       size_t dimensions) {
  const double n = (double)samples, mean = s->both / (2 * n);
  const double variance = s->squares / (2 * n) - mean * mean;
  if (!(variance > 0)) return false;
  for (size_t i = 0; i < dimensions; i++) {
    first[i * stride] = (s->product[i] - mean * s->apart[i]) / n / variance;
    total[i * stride] = s->apart_square[i] / n / 2 / variance;
  }
  return true;
}

static double mean_of(const tp_sobol_results *r) {
  tp_sum sum = {0};
  for (size_t k = 0; k < r->samples; k++) {
    tp_sum_add(&sum, r->values[k * (r->dimensions + 2)]);
    tp_sum_add(&sum, r->values[k * (r->dimensions + 2) + 1]);
  }
  return tp_sum_value(&sum) / (2 * (double)r->samples);
}

static void resample(sums *s, const tp_sobol_results *r, double about, uint64_t stream) {
  clear(s, r->dimensions);
  for (size_t k = 0; k < r->samples; k++) {
    const double part = tp_random_unit(tp_random_bits(stream, k));
    const size_t drawn = (size_t)(part * (double)r->samples);
    add(s, r->values + drawn * (r->dimensions + 2), about, r->dimensions);
  }
}

static void interval(tp_estimate *e, double *column, size_t count, double confidence) {
  tp_column_sort(column, count);
  const double tail = (1 - confidence) / 2;
  e->low = tp_column_quantile(column, count, tail, confidence).value;
  e->high = tp_column_quantile(column, count, 1 - tail, confidence).value;
}

/* Are there results of all, and enough? */
static bool check(const tp_sobol_results *r, size_t resamples, tp_message *message) {
  enum { RESAMPLES_LEAST = 100 };
  const tp_place nowhere = {0};
  if (r->samples < 2 || r->dimensions < 1 || resamples < RESAMPLES_LEAST) {
    (void)tp_refuse(message, TP_FAULT_RANGE, nowhere,
                    "Sobol' indices need 2 samples, 1 variable and %d resamples at least, not %zu, "
                    "%zu and %zu",
                    RESAMPLES_LEAST, r->samples, r->dimensions, resamples);
    return false;
  }
  for (size_t k = 0; k < r->samples * (r->dimensions + 2); k++) {
    if (isfinite(r->values[k])) continue;
    (void)tp_refuse(message, TP_FAULT_RANGE, nowhere,
                    "result %zu of sample %zu is not a finite number: Sobol' indices need them all",
                    k % (r->dimensions + 2) + 1, k / (r->dimensions + 2) + 1);
    return false;
  }
  return true;
}

/* `columns` holds the indices of all resamples, variable by variable, first orders first. */
static bool fill(tp_sobol_index *indices, double *columns, sums *s, const tp_sobol_results *r,
                 size_t resamples, uint64_t seed, double confidence) {
  const size_t d = r->dimensions;
  const double about = mean_of(r);
  clear(s, d);
  for (size_t k = 0; k < r->samples; k++) add(s, r->values + k * (d + 2), about, d);
  if (!indices_of(columns, columns + d, 1, s, r->samples, d)) return false;
  for (size_t i = 0; i < d; i++) {
    indices[i].first.value = columns[i];
    indices[i].total.value = columns[d + i];
  }
  const uint64_t stream = tp_random_stream(seed, TP_STREAM_BOOTSTRAP);
  size_t count = 0; /* one that draws equal results alone tells nothing */
  for (size_t k = 0; k < resamples; k++) {
    resample(s, r, about, tp_random_branch(stream, k));
    double *first = columns + count;
    if (indices_of(first, first + d * resamples, resamples, s, r->samples, d)) count++;
  }
  if (count == 0) return false;
  for (size_t i = 0; i < d; i++) {
    interval(&indices[i].first, columns + i * resamples, count, confidence);
    interval(&indices[i].total, columns + (d + i) * resamples, count, confidence);
  }
  return true;
}

tp_status tp_sobol_indices(tp_sobol_index *indices, const tp_sobol_results *results,
                           size_t resamples, uint64_t seed, double confidence,
                           tp_message *message) {
  const size_t d = results->dimensions;
  if (!check(results, resamples, message)) return TP_BAD_INPUT;
  tp_status status = TP_OK;
  double *columns = calloc(2 * d * resamples + 3 * d, sizeof *columns);
  tp_sobol_index *own = calloc(d, sizeof *own);
  if (columns == NULL || own == NULL) {
    status = tp_fail_memory(message, "Sobol' indices");
  } else {
    double *places = columns + 2 * d * resamples;
    sums s = {.apart = places, .product = places + d, .apart_square = places + 2 * d};
    if (fill(own, columns, &s, results, resamples, seed, confidence)) {
      memcpy(indices, own, d * sizeof *own);
    } else {
      status = tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                       "the result is the same for all samples: no variable has an influence");
    }
  }
  free(own);
  free(columns);
  return status;
}
