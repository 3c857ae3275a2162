/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bands with ten to a factor of ten in frequency: means of the spectrum's ordinates at the
 * geometric mean of the end frequencies. */

#include "roughness/bands.h"

#include <math.h>

static const double in_a_tenfold = 10;

/* The first ordinate beyond the band that begins with this one: by the index, which is the
 * frequency in steps of the spectrum. */
static size_t end_of(size_t from) {
  const double band = floor(in_a_tenfold * log10((double)from) + 1e-9);
  const size_t end = (size_t)ceil(pow(10, (band + 1) / in_a_tenfold) - 1e-9);
  return end > from ? end : from + 1;
}

bool tp_band_next(tp_band *band, const tp_profile *p) {
  const size_t from = band->count == 0 ? 1 : band->from + band->count;
  if (from >= p->density_count) return false;
  size_t end = end_of(from);
  if (end > p->density_count) end = p->density_count;
  double sum = 0;
  for (size_t k = from; k < end; k++) sum += p->densities[k].density;
  *band =
      (tp_band){.from = from,
                .count = end - from,
                .frequency = sqrt(p->densities[from].frequency * p->densities[end - 1].frequency),
                .density = sum / (double)(end - from)};
  return true;
}
