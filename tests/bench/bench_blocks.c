/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks held in arrays, in nanoseconds of computing time a block.
 *
 *     bench_blocks [BLOCKS]
 *
 * Measured: a million blocks of 6 and of 60 vertices, a rough underside below a level top: reading
 * the coordinates once (their sum, in eight lanes); moments of area by a loop as one writes it,
 * without a bound; the calls with one thread; all medians of ROUNDS. Verdicts on so many fewer that
 * they take as long. To be read: the critical angles where the caller vouches that outlines are
 * simple against reading is what the filter costs beside memory; against the same where that is
 * checked, what the check costs. The aim of moments and of the vouched angle is twice the reading
 * of 60 vertices; that of a verdict, with both limits and its factors, stands beside it. `threads`
 * is the time on the clock with two. `at map coordinates` is of the same blocks at x = 500 000 and
 * y = 4 600 000, as a GIS has them: as many nanoseconds as at the origin. */

#include "bench.h"

#include "topple.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 5, LEAST_BLOCKS = 1000, SOLVED_SHARE = 100, FEW_VERTICES = 6 };

/* Nanoseconds that a verdict is to take, of few vertices and of 60. */
static const double few_goal = 1e4, many_goal = 4e4;

typedef struct work {
  size_t blocks, vertices;
  double *xy, *a, *b;
  long *pivot;
  tp_outlines outlines;
  tp_blocks_options options;
  tp_blocks_summary summary;
  tp_message message;
} work;

static double read_all(const work *w) {
  double lanes[8] = {0};
  const size_t count = 2 * w->blocks * w->vertices;
  for (size_t k = 0; k + 8 <= count; k += 8) {
    for (int lane = 0; lane < 8; lane++) lanes[lane] += w->xy[k + lane];
  }
  return lanes[0] + lanes[1] + lanes[2] + lanes[3] + lanes[4] + lanes[5] + lanes[6] + lanes[7];
}

static tp_status reading(work *w) {
  w->a[0] = read_all(w);
  return TP_OK;
}

/* The direction of the centroid from the first vertex, as a loop over vertices gives it. */
static tp_status plain_loop(work *w) {
  for (size_t block = 0; block < w->blocks; block++) {
    const double *xy = w->xy + 2 * block * w->vertices;
    double x_sum = 0, y_sum = 0;
    double u0 = xy[2 * w->vertices - 2] - xy[0], v0 = xy[2 * w->vertices - 1] - xy[1];
    for (size_t k = 0; k < w->vertices; k++) {
      const double u = xy[2 * k] - xy[0], v = xy[2 * k + 1] - xy[1], c = u0 * v - u * v0;
      x_sum += (u0 + u) * c;
      y_sum += (v0 + v) * c;
      u0 = u;
      v0 = v;
    }
    w->a[block] = atan2(x_sum, y_sum);
  }
  return TP_OK;
}

static tp_status moments(work *w) {
  const tp_moment_columns columns = {.area = w->a, .area_error = w->b};
  return tp_outlines_moments(&columns, &w->summary, &w->outlines, &w->options, &w->message);
}

static tp_status angles(work *w) {
  const tp_critical_columns columns = {.angle_deg = w->a, .error_deg = w->b, .pivot = w->pivot};
  return tp_blocks_critical_angles(&columns, &w->summary, &w->outlines, &w->options, &w->message);
}

static tp_status vouched_angles(work *w) {
  w->options.simple = true;
  const tp_status status = angles(w);
  w->options.simple = false;
  return status;
}

static tp_status verdicts(work *w) {
  const tp_verdict_columns columns = {.first_angle_deg = w->a, .first_error_deg = w->b};
  w->outlines.count = w->blocks / SOLVED_SHARE;
  const tp_status status = tp_blocks_solve(&columns, &w->summary, &w->outlines, tp_numbers_of(30),
                                           tp_numbers_of(10), &w->options, &w->message);
  w->outlines.count = w->blocks;
  return status;
}

static tp_status one_by_one(work *w) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < w->blocks && status == TP_OK; k++) {
    tp_area_moments own;
    status = tp_outline_moments(&own, w->xy + 2 * k * w->vertices, w->vertices, &w->message);
    w->a[k] = own.area.value;
  }
  return status;
}

typedef struct part {
  const char *name;
  tp_status (*run)(work *w);
  size_t share;
} part;

static const part parts[] = {
    {"reading the coordinates", reading, 1},
    {"centroid by a plain loop", plain_loop, 1},
    {"moments, all", moments, 1},
    {"moments, call by call", one_by_one, 1},
    {"critical angles, vouched", vouched_angles, 1},
    {"critical angles, checked", angles, 1},
    {"verdicts", verdicts, SOLVED_SHARE},
};

static void draw(work *w) {
  uint32_t state = 1;
  const size_t lower = w->vertices - 2;
  for (size_t block = 0; block < w->blocks; block++) {
    double *xy = w->xy + 2 * block * w->vertices;
    for (size_t k = 0; k < lower; k++) {
      state = state * 1664525 + 1013904223;
      xy[2 * k] = (double)k / (double)(lower - 1);
      xy[2 * k + 1] = 0.1 / (double)lower * (double)(state >> 8) / 0x1p24;
    }
    const double height = 1 + (double)(state >> 8) / 0x1p24;
    memcpy(xy + 2 * lower, (double[]){1, height, 0, height}, 4 * sizeof *xy);
  }
}

static void move_all(work *w, double x, double y) {
  for (size_t k = 0; k < w->blocks * w->vertices; k++) {
    w->xy[2 * k] += x;
    w->xy[2 * k + 1] += y;
  }
}

/* The verdicts once more, and how many doubles do not tell, at map coordinates. */
static tp_status measure_moved(work *w) {
  static const double x = 500000, y = 4600000;
  double seconds[ROUNDS];
  const size_t blocks = w->blocks / SOLVED_SHARE;
  move_all(w, x, y);
  for (int round = 0; round < ROUNDS; round++) {
    const double began = bench_computed();
    const tp_status status = verdicts(w);
    seconds[round] = bench_computed() - began;
    if (status != TP_OK) return status;
  }
  move_all(w, -x, -y);
  const double median = gsl_stats_median(seconds, 1, ROUNDS);
  printf("%-28s %10.1f ns, %zu climbed (goal: as at the origin)\n", "verdicts at map coordinates",
         1e9 * median / (double)blocks, w->summary.climbed);
  return TP_OK;
}

static tp_status measure(work *w) {
  draw(w);
  w->outlines = tp_outlines_of(w->xy, w->blocks, w->vertices);
  w->options = tp_blocks_options_default();
  w->options.threads = 1;
  printf("%zu blocks of %zu vertices\n", w->blocks, w->vertices);
  double read = 0;
  for (size_t p = 0; p < sizeof parts / sizeof parts[0]; p++) {
    double seconds[ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
      const double began = bench_computed();
      const tp_status status = parts[p].run(w);
      seconds[round] = bench_computed() - began;
      if (status != TP_OK) return status;
    }
    const double median = gsl_stats_median(seconds, 1, ROUNDS);
    const size_t blocks = w->blocks / parts[p].share;
    const double each = median / (double)blocks;
    if (p == 0) read = each;
    printf("%-28s %10.1f ns, %7.1f of reading", parts[p].name, 1e9 * each, each / read);
    if (parts[p].run == verdicts) {
      printf(" (goal %.0f ns)", w->vertices == FEW_VERTICES ? few_goal : many_goal);
      if (w->vertices == FEW_VERTICES) printf("; a million %.1f s (goal 10 s)", 1e6 * each);
    }
    printf("\n");
  }
  printf("%-28s %10zu\n", "climbed, of the last", w->summary.climbed);
  tp_status status = measure_moved(w);
  if (status != TP_OK) return status;
  w->options.threads = 2;
  const double began = bench_now();
  status = angles(w);
  const double seconds = bench_now() - began;
  printf("%-28s %10.1f ns\n", "checked, threads", 1e9 * seconds / (double)w->blocks);
  return status;
}

static tp_status measure_both(work *w) {
  w->vertices = FEW_VERTICES;
  const tp_status status = measure(w);
  if (status != TP_OK) return status;
  w->vertices = 60;
  return measure(w);
}

int main(int argc, char **argv) {
  enum { MOST_VERTICES = 60 };
  work w = {.blocks = argc > 1 ? (size_t)bench_count(argv[1], LEAST_BLOCKS) : 1000000};
  if (argc > 2 || w.blocks == 0) {
    fprintf(stderr, "usage: bench_blocks [BLOCKS, at least %d]\n", LEAST_BLOCKS);
    return 2;
  }
  w.xy = calloc(2 * w.blocks * MOST_VERTICES, sizeof *w.xy);
  w.a = calloc(w.blocks, sizeof *w.a);
  w.b = calloc(w.blocks, sizeof *w.b);
  w.pivot = calloc(w.blocks, sizeof *w.pivot);
  tp_status status = TP_OUT_OF_MEMORY;
  if (w.xy != NULL && w.a != NULL && w.b != NULL && w.pivot != NULL) status = measure_both(&w);
  if (status != TP_OK) fprintf(stderr, "%s: %s\n", tp_status_meaning(status), w.message.text);
  free(w.xy);
  free(w.a);
  free(w.b);
  free(w.pivot);
  return status == TP_OK ? 0 : BENCH_FAILED;
}
