/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a point of a generated profile costs, with its exact coordinates: self-affine, and teeth
 * with scatter. Medians, in ns a point; 50 is the aim. */

#include "generate/generate.h"

#include "bench.h"

#include <string.h>

enum { SAMPLES = 9, NS = 1000000000 };

static void fail(const char *what) {
  fprintf(stderr, "bench_generate: %s\n", what);
  exit(BENCH_FAILED);
}

static double time_self_affine(long steps, uint64_t seed) {
  tp_self_affine_options o;
  tp_polyline line = {0};
  bool no_wave = false;
  tp_self_affine_options_init(&o);
  o.steps = steps;
  o.hurst = 0.8;
  o.seed = seed;
  fmpq_set_si(o.step, 1, 2);
  fmpq_set_si(o.shortest, 1, 1);
  fmpq_set_si(o.longest, steps, 2);
  fmpq_set_si(o.size, 1, 1);
  const double begin = bench_computed();
  if (!tp_generate_self_affine(&line, &no_wave, &o) || no_wave) fail("no profile");
  const double taken = bench_computed() - begin;
  tp_polyline_clear(&line);
  tp_self_affine_options_clear(&o);
  return taken * NS / (double)steps;
}

static double time_teeth(long count, uint64_t seed) {
  tp_teeth_options o;
  tp_polyline line = {0};
  tp_teeth_options_init(&o);
  o.count = count;
  o.seed = seed;
  fmpq_set_si(o.wavelength, 60, 1);
  fmpq_set_si(o.amplitude, 5, 1);
  fmpq_set_si(o.wavelength_scatter, 1, 5);
  fmpq_set_si(o.amplitude_scatter, 1, 5);
  fmpq_set_si(o.skew_scatter, 1, 5);
  const double begin = bench_computed();
  if (!tp_generate_teeth(&line, &o)) fail("no profile");
  const double taken = bench_computed() - begin;
  tp_polyline_clear(&line);
  tp_teeth_options_clear(&o);
  return taken * NS / (double)count;
}

static double median_of(double (*time)(long points, uint64_t seed), long points) {
  double samples[SAMPLES];
  for (int k = 0; k < SAMPLES; k++) samples[k] = time(points, (uint64_t)k);
  return gsl_stats_median(samples, 1, SAMPLES);
}

int main(void) {
  static const long counts[] = {1000, 10000, 100000, 1000000};
  printf("%10s %18s %18s\n", "points", "self-affine (ns)", "teeth (ns)");
  for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
    printf("%10ld %18.1f %18.1f\n", counts[k], median_of(time_self_affine, counts[k]),
           median_of(time_teeth, counts[k]));
  }
  return 0;
}
