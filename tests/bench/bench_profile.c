/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The roughness of long profiles.
 *
 *     bench_profile [POINTS]
 *
 * A random walk of so many points (10^3 to 10^6 unless given), four decimals each, every 0.1 mm: a
 * file of CSV, read; the same points measured, from exact points to all numbers (bounded sums,
 * facing facets, correlations at their own steps, lags, spectrum, exponents); the same from an
 * array of doubles in one public call. Medians of 5. To be read: seconds, and nanoseconds a point.
 */

#include "bench.h"

#include "roughness/profile.h"
#include "scene_reading/csv.h"

#include <string.h>

enum { SAMPLES = 5, LINE_ROOM = 32 };

static char *walk(size_t count, double *xy) {
  char *text = malloc(count * LINE_ROOM), *end = text;
  uint64_t state = 1;
  long height = 0;
  for (size_t k = 0; k < count && text != NULL; k++) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    height += (long)(state >> 40) % 401 - 200;
    xy[2 * k] = (double)k * 0.1;
    xy[2 * k + 1] = (double)height * 1e-4;
    end += sprintf(end, "%zu.%zu,%.4f\n", k / 10, k % 10, xy[2 * k + 1]);
  }
  return text;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void tell(const char *what, double *seconds, size_t count) {
  qsort(seconds, SAMPLES, sizeof *seconds, compare);
  const double middle = seconds[SAMPLES / 2];
  printf("%10zu  %-28s %9.2f ms %8.1f ns/point\n", count, what, 1e3 * middle,
         1e9 * middle / (double)count);
}

static bool measure(size_t count) {
  double reading[SAMPLES], measuring[SAMPLES], calling[SAMPLES];
  double *xy = malloc(2 * count * sizeof *xy);
  const char *unit = NULL;
  char *text = xy != NULL ? walk(count, xy) : NULL;
  const tp_profile_options options = tp_profile_options_default();
  bool done = text != NULL;
  for (int s = 0; s < SAMPLES && done; s++) {
    tp_polyline line = {0};
    tp_notes notes = {0};
    tp_profile *profile = NULL, *called = NULL;
    double began = bench_computed();
    done = tp_csv_read_text(&line, &unit, text, "walk.csv", false, &notes, NULL) == TP_OK;
    reading[s] = bench_computed() - began;
    const tp_profile_subject subject = {
        .chain = &line, .length_unit = "mm", .metres_per_unit = 1e-3};
    began = bench_computed();
    done = done && tp_profile_measure(&profile, &subject, &options, NULL) == TP_OK;
    measuring[s] = bench_computed() - began;
    began = bench_computed();
    done = done && tp_profile_of_points(&called, tp_coordinates_of(xy, count), "mm", &options,
                                        NULL) == TP_OK;
    calling[s] = bench_computed() - began;
    tp_profile_free(profile);
    tp_profile_free(called);
    tp_polyline_clear(&line);
  }
  if (done) {
    tell("CSV read", reading, count);
    tell("measured", measuring, count);
    tell("from doubles, in one call", calling, count);
  }
  free(text);
  free(xy);
  return done;
}

int main(int argc, char **argv) {
  const long given = argc > 1 ? bench_count(argv[1], 16) : 0;
  for (size_t count = 1000; given == 0 && count <= 1000000; count *= 10) {
    if (!measure(count)) return BENCH_FAILED;
  }
  return given > 0 && !measure((size_t)given) ? BENCH_FAILED : 0;
}
