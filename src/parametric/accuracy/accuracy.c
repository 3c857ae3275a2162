/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of precisions for each method, the time of one evaluation as the median of five samples,
 * and the true error against an exact value of 6144 bits (docs/accuracy.md). */

#include "accuracy/accuracy.h"

#include "common/clock.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

/* The exact value is one at so many bits, half again as many as the dearest price. */
enum { TRUTH_BITS = 6144 };

#define BALLS                                                                                      \
  {TP_LEVEL_BALL, 53}, {TP_LEVEL_BALL, 64}, {TP_LEVEL_BALL, 128}, {TP_LEVEL_BALL, 256},            \
      {TP_LEVEL_BALL, 512}, {TP_LEVEL_BALL, 1024}, {TP_LEVEL_BALL, 2048}, {                        \
    TP_LEVEL_BALL, 4096                                                                            \
  }
#define EXACT                                                                                      \
  {TP_LEVEL_EXACT, 320}, {TP_LEVEL_EXACT, 1280}, {                                                 \
    TP_LEVEL_EXACT, 4096                                                                           \
  }

static const tp_rung sums[] = {
    {TP_LEVEL_DOUBLE, 64}, {TP_LEVEL_COMPENSATED, 128}, BALLS, {TP_LEVEL_EXACT, 64}, EXACT};
static const tp_rung few_sums[] = {{TP_LEVEL_DOUBLE, 64},
                                   {TP_LEVEL_COMPENSATED, 128},
                                   {TP_LEVEL_BALL, 128},
                                   {TP_LEVEL_EXACT, 320}};
static const tp_rung triangles[] = {{TP_LEVEL_DOUBLE, 64}, BALLS, {TP_LEVEL_EXACT, 64}, EXACT};
static const tp_rung few_triangles[] = {
    {TP_LEVEL_DOUBLE, 64}, {TP_LEVEL_BALL, 128}, {TP_LEVEL_EXACT, 320}};
static const tp_rung balls[] = {BALLS};
static const tp_rung limits[] = {{TP_LEVEL_DOUBLE, 64}, BALLS, EXACT};
static const tp_rung few_limits[] = {
    {TP_LEVEL_DOUBLE, 64}, {TP_LEVEL_BALL, 128}, {TP_LEVEL_EXACT, 320}};

#define PRICES(list) ((tp_accuracy_prices){list, sizeof(list) / sizeof *(list)})

tp_accuracy_prices tp_accuracy_prices_of(tp_accuracy_method method, bool few) {
  switch (method) {
  case TP_ACCURACY_BOUNDARY:
    return few ? PRICES(few_sums) : PRICES(sums);
  case TP_ACCURACY_TRIANGLES:
    return few ? PRICES(few_triangles) : PRICES(triangles);
  case TP_ACCURACY_ROUNDED_PAPER:
  case TP_ACCURACY_ROUNDED_EXACT:
    break;
  case TP_ACCURACY_LIMIT:
    return few ? PRICES(few_limits) : PRICES(limits);
  case TP_ACCURACY_ONSET:
    return few ? PRICES(few_sums) : PRICES(sums);
  }
  return PRICES(balls);
}

tp_accuracy *tp_accuracy_new(void) {
  tp_accuracy *own = calloc(1, sizeof *own);
  if (own != NULL) own->size = sizeof *own;
  return own;
}

void tp_accuracy_free(tp_accuracy *accuracy) {
  if (accuracy == NULL) return;
  free(accuracy->title);
  free(accuracy->runs);
  free(accuracy->values);
  for (size_t k = 0; k < accuracy->source_count; k++) free(accuracy->sources[k]);
  free(accuracy->sources);
  tp_tilt_convergence_free(accuracy->simulated);
  free(accuracy);
}

static tp_status add_run(tp_accuracy *a, tp_accuracy_run run) {
  tp_accuracy_run *runs = realloc(a->runs, (a->run_count + 1) * sizeof *runs);
  if (runs == NULL) return TP_OUT_OF_MEMORY;
  a->runs = runs;
  runs[a->run_count++] = run;
  return TP_OK;
}

static tp_status add_value(tp_accuracy *a, tp_accuracy_value value) {
  tp_accuracy_value *values = realloc(a->values, (a->value_count + 1) * sizeof *values);
  if (values == NULL) return TP_OUT_OF_MEMORY;
  a->values = values;
  values[a->value_count++] = value;
  return TP_OK;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Seconds that so many evaluations take together. */
static double time_repeats(tp_status *status, arb_t degrees, bool *found,
                           const tp_accuracy_way *way, tp_rung rung, long repeats) {
  const double began = tp_clock_now();
  for (long k = 0; k < repeats && *status == TP_OK; k++) {
    *status = way->evaluate(degrees, found, way->subject, rung);
  }
  return tp_clock_now() - began;
}

/* Seconds of one evaluation: the median of five samples of at least 1 ms, of fewer where one alone
 * takes long. How many evaluations a sample has is raised until it lasts so long: a clock may tick
 * by a tenth of a millisecond, as browsers' do, and the first evaluation may take longer than
 * others. `degrees` and `*found` are those of the last. */
static tp_status time_way(double *seconds, arb_t degrees, bool *found, const tp_accuracy_way *way,
                          tp_rung rung) {
  enum { MOST_SAMPLES = 5, MOST_REPEATS = 1 << 24 };
  static const double sample_s = 1e-3, long_s = 0.1, very_long_s = 1;
  double samples[MOST_SAMPLES];
  tp_status status = TP_OK;
  const double once = time_repeats(&status, degrees, found, way, rung, 1);
  const int count = once > very_long_s ? 0 : once > long_s ? 2 : MOST_SAMPLES;
  long repeats = 1;
  double took = once;
  while (took < sample_s && repeats < MOST_REPEATS && status == TP_OK && *found) {
    const double raised = took > 0 ? ceil((double)repeats * sample_s / took) : INFINITY;
    repeats = (long)fmax(2.0 * (double)repeats, fmin(8.0 * (double)repeats, raised));
    took = time_repeats(&status, degrees, found, way, rung, repeats);
  }
  for (int s = 0; s < count && status == TP_OK && *found; s++) {
    samples[s] = time_repeats(&status, degrees, found, way, rung, repeats) / (double)repeats;
  }
  qsort(samples, (size_t)count, sizeof *samples, compare);
  *seconds = count > 0 ? samples[count / 2] : once;
  return status;
}

static double upwards(const mag_t size) {
  arf_t value;
  arf_init(value);
  arf_set_mag(value, size);
  const double result = arf_get_d(value, ARF_RND_UP);
  arf_clear(value);
  return result;
}

static double log10_of(const mag_t size) {
  return tp_bits_digits(tp_mag_log2(size));
}

static void judge(tp_accuracy_run *run, const arb_t degrees, const arb_t truth) {
  run->bound = upwards(arb_radref(degrees));
  run->bound_log10 = log10_of(arb_radref(degrees));
  arf_t away;
  mag_t error;
  arf_init(away);
  mag_init(error);
  arf_sub(away, arb_midref(degrees), arb_midref(truth), ARF_PREC_EXACT, ARF_RND_NEAR);
  arf_get_mag(error, away);
  run->true_error = upwards(error);
  run->true_error_log10 = log10_of(error);
  arf_clear(away);
  mag_clear(error);
}

static tp_status measure_rung(tp_accuracy *a, const tp_accuracy_way *way, tp_rung rung,
                              const arb_t truth) {
  const bool unproven = way->method == TP_ACCURACY_LIMIT && rung.level == TP_LEVEL_DOUBLE;
  tp_accuracy_run run = {.method = way->method,
                         .level = rung.level,
                         .bits = rung.bits,
                         .vertices = way->vertices,
                         .has_bound = !unproven};
  bool found = false;
  arb_t degrees;
  arb_init(degrees);
  tp_status status = time_way(&run.seconds, degrees, &found, way, rung);
  if (status == TP_OK && found) {
    judge(&run, degrees, truth);
    status = add_run(a, run);
  }
  arb_clear(degrees);
  return status;
}

tp_status tp_accuracy_measure(tp_accuracy *a, const tp_accuracy_way *way) {
  bool found = false;
  arb_t truth;
  arb_init(truth);
  const tp_rung truth_rung = {way->truth_level, TRUTH_BITS};
  tp_status status = way->evaluate(truth, &found, way->subject, truth_rung);
  if (status == TP_OK && found) {
    status = add_value(a, (tp_accuracy_value){way->method, way->vertices, tp_ball_bounded(truth)});
    for (size_t k = 0; k < way->prices.count && status == TP_OK; k++) {
      status = measure_rung(a, way, way->prices.rungs[k], truth);
    }
  }
  arb_clear(truth);
  return status;
}
