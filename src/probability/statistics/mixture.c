/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Shares by distance of the centres, draws from a chosen part, and the weight of a sample as a
 * ratio of densities. */

#include "statistics/mixture.h"

#include "generate/random.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double dot(const double *a, const double *b, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* So wide that the mean square of a point is that of failures at the distance of the nearest
 * centre: b^2 towards it, 1 across. */
static void widen(tp_mixture *m) {
  static const double unknown = 3; /* deviations, where there is no centre */
  double least = m->count > 0 ? INFINITY : unknown * unknown;
  for (size_t k = 0; k < m->count; k++) {
    const double *c = m->centres + k * m->dimensions;
    least = fmin(least, dot(c, c, m->dimensions));
  }
  m->spread = sqrt(1 + fmax(least - 1, 0) / (double)m->dimensions);
}

tp_status tp_mixture_init(tp_mixture *mixture, const double *centres, size_t count,
                          size_t dimensions, tp_message *message) {
  *mixture = (tp_mixture){.dimensions = dimensions, .count = count, .wide = 0.2};
  mixture->centres = calloc(TP_MIXTURE_CENTRES * dimensions, sizeof *mixture->centres);
  if (mixture->centres == NULL) return tp_fail_memory(message, "the samples");
  if (count > 0) memcpy(mixture->centres, centres, count * dimensions * sizeof *centres);
  double least = INFINITY, sum = 0;
  for (size_t k = 0; k < count; k++) {
    const double *c = centres + k * dimensions;
    mixture->shares[k] = dot(c, c, dimensions);
    least = fmin(least, mixture->shares[k]);
  }
  for (size_t k = 0; k < count; k++) {
    mixture->shares[k] = exp((least - mixture->shares[k]) / 2);
    sum += mixture->shares[k];
  }
  for (size_t k = 0; k < count; k++) mixture->shares[k] /= sum;
  widen(mixture);
  return TP_OK;
}

void tp_mixture_clear(tp_mixture *mixture) {
  free(mixture->centres);
  mixture->centres = NULL;
}

void tp_mixture_add(tp_mixture *mixture, const double *centre) {
  const size_t n = mixture->dimensions;
  if (mixture->count == TP_MIXTURE_CENTRES) return;
  memcpy(mixture->centres + mixture->count * n, centre, n * sizeof *centre);
  const double share = 1 / (double)(mixture->count + 1);
  for (size_t k = 0; k < mixture->count; k++) mixture->shares[k] *= 1 - share;
  mixture->shares[mixture->count++] = share;
  widen(mixture);
}

static double score(uint64_t stream, uint64_t k) {
  const uint64_t bits = tp_random_bits(stream, k);
  const double tail =
      tp_random_unit(bits) / 2; /* the last bits of the 64, which it leaves, say which */
  return (bits & 1U) != 0 ? gsl_cdf_ugaussian_Pinv(tail) : gsl_cdf_ugaussian_Qinv(tail);
}

/* The centre that a sample is drawn around; NULL: the wide part. */
static const double *choose(const tp_mixture *m, double chance) {
  if (m->count == 0 || chance < m->wide) return NULL;
  double left = (chance - m->wide) / (1 - m->wide);
  size_t k = 0;
  while (k + 1 < m->count && left >= m->shares[k]) left -= m->shares[k++];
  return m->centres + k * m->dimensions;
}

void tp_mixture_draw(const tp_mixture *mixture, double *z, uint64_t stream, uint64_t k) {
  const size_t n = mixture->dimensions;
  const double *centre =
      choose(mixture, tp_random_unit(tp_random_bits(tp_random_branch(stream, n), k)));
  for (size_t i = 0; i < n; i++) {
    const double own = score(tp_random_branch(stream, i), k);
    z[i] = centre != NULL ? centre[i] + own : mixture->spread * own;
  }
}

/* phi(z - c) / phi(z) = exp(c z - |c|^2 / 2), and the wide part's likewise. */
double tp_mixture_weight(const tp_mixture *mixture, const double *z, double *parts) {
  const size_t n = mixture->dimensions;
  const double s = mixture->spread, square = dot(z, z, n);
  const double around = mixture->count > 0 ? 1 - mixture->wide : 0;
  double sum = (1 - around) * pow(s, -(double)n) * exp(square / 2 * (1 - 1 / (s * s)));
  for (size_t k = 0; k < mixture->count; k++) {
    const double *c = mixture->centres + k * n;
    const double part = around * mixture->shares[k] * exp(dot(c, z, n) - dot(c, c, n) / 2);
    if (parts != NULL) parts[k] = part;
    sum += part;
  }
  for (size_t k = 0; k < mixture->count && parts != NULL; k++) parts[k] /= sum;
  return 1 / sum;
}

double tp_mixture_expected(const tp_mixture *mixture) {
  double most = 0;
  for (size_t k = 0; k < mixture->count; k++) {
    most = fmax(most, tp_mixture_weight(mixture, mixture->centres + k * mixture->dimensions, NULL));
  }
  return most;
}
