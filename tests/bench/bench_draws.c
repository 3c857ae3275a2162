/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples, distributions and subsets.
 *
 *     bench_draws [SAMPLES]
 *
 * So many samples (10^6 unless given) of five numbers by each method, independent and dependent; as
 * many quantiles of each distribution, a tenth of beta; a probability of 1e-6 by subset simulation
 * of a plane, what it costs but for the plane. To be read: nanoseconds a sample, a quantile, a
 * call. */

#include "bench.h"

#include "sampling/distribution.h"
#include "sampling/draws.h"
#include "statistics/subset_simulation.h"

enum { DIMENSIONS = 5, SUBSET_SAMPLES = 10000 };

static bool draw(tp_draw_method method, uint64_t samples, const double *correlation) {
  const tp_draws draws = {method, 1, samples, 1, DIMENSIONS, correlation};
  tp_draws_walk *walk;
  double sum = 0;
  if (tp_draws_begin(&walk, &draws, 0, NULL, NULL) != TP_OK) return false;
  const double began = bench_computed();
  for (uint64_t k = 0; k < samples; k++) {
    double u[DIMENSIONS];
    tp_draws_next(walk, u);
    sum += u[DIMENSIONS - 1];
  }
  const double seconds = bench_computed() - began;
  tp_draws_end(walk);
  printf("%-16s %-12s %8.1f ns a sample of %d (mean %.6f)\n", tp_draw_method_name(method),
         correlation == NULL ? "independent" : "dependent", 1e9 * seconds / (double)samples,
         DIMENSIONS, sum / (double)samples);
  return true;
}

static void quantiles(const char *what, const tp_distribution *d, uint64_t count) {
  double sum = 0;
  const double began = bench_computed();
  for (uint64_t k = 0; k < count; k++) {
    sum += tp_distribution_quantile(d, ((double)k + 0.5) / (double)count);
  }
  const double seconds = bench_computed() - began;
  printf("%-29s %8.1f ns a quantile (mean %.6f)\n", what, 1e9 * seconds / (double)count,
         sum / (double)count);
}

static tp_status plane(double *g, void *context, const double *x, size_t count,
                       tp_message *message) {
  (void)context, (void)message;
  for (size_t k = 0; k < count; k++) {
    g[k] = 4.753424308822899;
    for (size_t i = 0; i < DIMENSIONS; i++) g[k] -= x[k * DIMENSIONS + i] * 0.44721359549995793;
  }
  return TP_OK;
}

static bool subsets(void) {
  const tp_distribution z = tp_distribution_normal(0, 1), all[] = {z, z, z, z, z};
  const tp_reliability problem = {DIMENSIONS, all, NULL, plane, NULL};
  tp_subsets own;
  const double began = bench_computed();
  if (tp_subset_simulate(&own, &problem, NULL, 0, SUBSET_SAMPLES, 1, 0.95, NULL) != TP_OK)
    return false;
  const double seconds = bench_computed() - began;
  printf("%-29s %8.1f ns a call, %.0f calls (%.3g, from %.3g to %.3g)\n", "subset simulation",
         1e9 * seconds / (double)own.calls, (double)own.calls, own.probability.value,
         own.probability.low, own.probability.high);
  return true;
}

int main(int count, char **arguments) {
  static const tp_draw_method methods[] = {TP_DRAW_MONTE_CARLO, TP_DRAW_LATIN_HYPERCUBE,
                                           TP_DRAW_SOBOL};
  const long asked = count > 1 ? bench_count(arguments[1], 10) : 1000000;
  const uint64_t samples = (uint64_t)asked;
  double correlation[DIMENSIONS * DIMENSIONS];
  if (asked == 0) return BENCH_FAILED;
  for (int k = 0; k < DIMENSIONS * DIMENSIONS; k++) {
    correlation[k] = k / DIMENSIONS == k % DIMENSIONS ? 1 : 0.3;
  }
  for (int k = 0; k < 6; k++) {
    if (!draw(methods[k / 2], samples, k % 2 == 0 ? NULL : correlation)) return BENCH_FAILED;
  }
  const tp_distribution phi = tp_distribution_normal(30, 2);
  const tp_distribution cohesion = tp_distribution_lognormal(30, 10);
  const tp_distribution seismic = tp_distribution_triangular(0, 0.05, 0.2);
  const tp_distribution level = tp_distribution_beta(2, 3, 10, 20);
  const tp_distribution cut = tp_distribution_truncated(phi, 25, 35);
  quantiles("normal", &phi, samples);
  quantiles("normal, truncated", &cut, samples);
  quantiles("lognormal", &cohesion, samples);
  quantiles("triangular", &seismic, samples);
  quantiles("beta", &level, samples / 10);
  return subsets() ? EXIT_SUCCESS : BENCH_FAILED;
}
