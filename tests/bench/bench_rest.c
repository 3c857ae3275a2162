/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What it takes to set a block down on a rough profile, exactly.
 *
 * Measured: a block of 100 vertices on profiles of 10^3 to 10^6 points, from a random walk with a
 * fixed seed: the drop, the turns and their contacts (rest/settle.h), without the checks of the
 * scene before and its contact after; medians of 5. To be read: seconds grow with the profile, as
 * each of its points is turned into doubles and looked at once, not with its square. */

#include "bench.h"

#include "rest/settle.h"

#include <math.h>

enum { ROUNDS = 5, CORNERS = 100 };

static bool append(tp_polyline *line, double x, double y) {
  fmpq_t exact_x, exact_y;
  fmpq_init(exact_x);
  fmpq_init(exact_y);
  fmpq_set_si(exact_x, lround(x * 1e6), 1000000);
  fmpq_set_si(exact_y, lround(y * 1e6), 1000000);
  const bool done = tp_polyline_append(line, exact_x, exact_y, (tp_mark){0, 0});
  fmpq_clear(exact_x);
  fmpq_clear(exact_y);
  return done;
}

static double drawn(unsigned long *state) {
  *state = *state * 6364136223846793005UL + 1442695040888963407UL;
  return (double)(*state >> 11) / 9007199254740992.0 - 0.5;
}

static bool make(tp_polyline *block, tp_polyline *base, long points) {
  unsigned long state = 16;
  bool done = true;
  for (long k = 0; k < CORNERS && done; k++) {
    const double angle = 8 * atan(1) * (double)k / CORNERS, reach = 50 + 5 * drawn(&state);
    done = append(block, reach * cos(angle), 200 + 0.8 * reach * sin(angle));
  }
  double height = 0;
  for (long k = 0; k < points && done; k++) {
    height = 0.9 * height + 2 * drawn(&state);
    done = append(base, -100 + 200 * (double)k / (double)(points - 1), height);
  }
  return done && append(base, 100, -900) && append(base, -100, -900);
}

int main(void) {
  printf("points          ms   turns\n");
  for (long points = 1000; points <= 1000000; points *= 10) {
    tp_polyline block = {0}, base = {0};
    tp_exact_point centroid;
    tp_exact_point_init(&centroid);
    fmpq_set_si(&centroid.x, 1, 2);
    fmpq_set_si(&centroid.y, 200, 1);
    double seconds[ROUNDS];
    long turns = 0;
    bool done = make(&block, &base, points);
    for (int k = 0; k < ROUNDS && done; k++) {
      tp_settling settling;
      const double began = bench_computed();
      done = tp_settle(&settling, &block, &base, &centroid, NULL) == TP_OK;
      seconds[k] = bench_computed() - began;
      if (done) turns = settling.turns;
      if (done) tp_settling_clear(&settling);
    }
    if (!done) return BENCH_FAILED;
    printf("%7ld %10.2f %7ld\n", points, 1e3 * gsl_stats_median(seconds, 1, ROUNDS), turns);
    tp_exact_point_clear(&centroid);
    tp_polyline_clear(&block);
    tp_polyline_clear(&base);
  }
  return 0;
}
