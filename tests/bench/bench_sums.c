/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moment sums in their four arithmetics beside a plain read of the same coordinates.
 *
 *     bench_sums [MOST_VERTICES]
 *
 * Measured, on the rough outline of accuracy/: a sum over both arrays, which reads every byte of
 * them and does next to nothing else; a plain loop for area and centroid, without any bound; area
 * and centroid (3 sums) and all six with their bounds in double, in pairs, exactly and in balls of
 * 128 bits. Medians of 9 samples, the methods in turn, each sample repeated to last 5 ms. To be
 * read: nanoseconds per vertex. The first table, by the best instruction set and one thread, tells
 * by `/read` what area and centroid cost beyond fetching their input: large where the coordinates
 * lie in cache, falling as memory becomes the limit. The second table is every instruction set of
 * this machine, the third are threads. Exact and ball are left out beyond 10^5 vertices. */

#include "bench.h"

#include "accuracy/rough_outline.h"

#include "block/ring_sums.h"

#include <math.h>

enum { SAMPLES = 9, MOST_METHODS = 12, LANES = 8, BALL_BITS = 128, MOST_SLOW = 100000 };

typedef struct input {
  long count;
  double *u, *v;
  fmpz *x, *y; /* NULL beyond MOST_SLOW vertices */
} input;

typedef enum what { READ, PLAIN_LOOP, DOUBLE, PAIRS, EXACT, BALL } what;

typedef struct method {
  what what;
  tp_sums_plan plan;
} method;

static volatile double sink; /* what the compiler must not leave out */

/* Sixteen sums at once, so that no addition waits for the one before. */
static void read_plainly(const input *in) {
  double a[LANES] = {0}, b[LANES] = {0}, total = 0;
  long k = 0;
  for (; k + LANES <= in->count; k += LANES) {
    for (int lane = 0; lane < LANES; lane++) {
      a[lane] += in->u[k + lane];
      b[lane] += in->v[k + lane];
    }
  }
  for (; k < in->count; k++) total += in->u[k] + in->v[k];
  for (int lane = 0; lane < LANES; lane++) total += a[lane] + b[lane];
  sink = total;
}

/* As it is written when nobody asks for a bound. */
static void sum_in_a_loop(const input *in) {
  double area = 0, first_u = 0, first_v = 0;
  for (long k = 0, before = in->count - 1; k < in->count; before = k++) {
    const double c = in->u[before] * in->v[k] - in->u[k] * in->v[before];
    area += c;
    first_u += (in->u[before] + in->u[k]) * c;
    first_v += (in->v[before] + in->v[k]) * c;
  }
  sink = area + first_u + first_v;
}

static void sum_exactly(const input *in, int sum_count) {
  fmpz sums[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_init(sums + k);
  tp_ring_sums_exact_first(sums, in->x, in->y, in->count, sum_count);
  sink = fmpz_get_d(sums + TP_A2);
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_clear(sums + k);
}

static void sum_in_balls(const input *in, int sum_count) {
  arb_struct sums[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_init(sums + k);
  tp_ring_sums_ball_first(sums, in->x, in->y, in->count, BALL_BITS, sum_count);
  sink = arf_get_d(arb_midref(sums + TP_A2), ARF_RND_NEAR);
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_clear(sums + k);
}

static void run(const method *m, const input *in) {
  double sums[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  tp_double_pair pairs[TP_SUM_COUNT];
  switch (m->what) {
  case READ:
    read_plainly(in);
    break;
  case PLAIN_LOOP:
    sum_in_a_loop(in);
    break;
  case DOUBLE:
    tp_ring_sums_double_first(sums, bounds, in->u, in->v, in->count, true, m->plan);
    sink = sums[TP_A2] + bounds[TP_A2];
    break;
  case PAIRS:
    tp_ring_sums_compensated_first(pairs, bounds, in->u, in->v, in->count, m->plan);
    sink = pairs[TP_A2].high + bounds[TP_A2];
    break;
  case EXACT:
    sum_exactly(in, m->plan.sum_count);
    break;
  case BALL:
    sum_in_balls(in, m->plan.sum_count);
    break;
  }
}

static double seconds_of(const method *m, const input *in, long repeats) {
  const double began = bench_now();
  for (long k = 0; k < repeats; k++) run(m, in);
  return bench_now() - began;
}

/* How often a method has to run for 5 ms; warms the caches up as well. */
static long repeats_of(const method *m, const input *in) {
  long repeats = 1;
  while (seconds_of(m, in, repeats) < 5e-3) repeats *= 2;
  return repeats;
}

/* Nanoseconds per vertex; not a number where a method is left out. */
static void measure(double *per_vertex, const input *in, const method *methods, int count) {
  double samples[MOST_METHODS][SAMPLES];
  long repeats[MOST_METHODS];
  for (int k = 0; k < count; k++) {
    const bool left_out = methods[k].what >= EXACT && in->x == NULL;
    repeats[k] = left_out ? 0 : repeats_of(methods + k, in);
  }
  for (int s = 0; s < SAMPLES; s++) {
    for (int k = 0; k < count; k++) {
      const double seconds = seconds_of(methods + k, in, repeats[k]);
      samples[k][s] = 1e9 * seconds / ((double)repeats[k] * (double)in->count);
    }
  }
  for (int k = 0; k < count; k++) {
    per_vertex[k] = repeats[k] == 0 ? NAN : gsl_stats_median(samples[k], 1, SAMPLES);
  }
}

static void input_clear(input *in) {
  for (long k = 0; k < in->count; k++) {
    if (in->x != NULL) fmpz_clear(in->x + k);
    if (in->y != NULL) fmpz_clear(in->y + k);
  }
  free(in->u);
  free(in->v);
  free(in->x);
  free(in->y);
}

/* Centred, as tp_lattice_init leaves the coordinates. */
static void fill(input *in) {
  tp_rough_outline(in->u, in->v, in->count);
  const double middle_u = (double)(long)(in->u[in->count - 2] / 2);
  const double middle_v = (double)(long)(in->v[in->count - 2] / 2);
  for (long k = 0; k < in->count; k++) {
    in->u[k] -= middle_u;
    in->v[k] -= middle_v;
    if (in->x == NULL) continue;
    fmpz_set_si(in->x + k, (long)in->u[k]);
    fmpz_set_si(in->y + k, (long)in->v[k]);
  }
}

static bool input_init(input *in, long count) {
  const size_t size = (size_t)count;
  const bool slow = count <= MOST_SLOW;
  *in = (input){.count = count};
  in->u = calloc(size, sizeof *in->u);
  in->v = calloc(size, sizeof *in->v);
  if (slow) in->x = calloc(size, sizeof *in->x);
  if (slow) in->y = calloc(size, sizeof *in->y);
  if (in->u == NULL || in->v == NULL || (slow && (in->x == NULL || in->y == NULL))) {
    input_clear(in);
    return false;
  }
  fill(in);
  return true;
}

static void print_numbers(const double *numbers, int count) {
  for (int k = 0; k < count; k++) {
    if (isnan(numbers[k])) {
      printf(" %8s", "-");
    } else {
      printf(" %8.3f", numbers[k]);
    }
  }
}

static void print_arithmetics(const input *in) {
  static const method methods[] = {{READ, {0}},
                                   {PLAIN_LOOP, {0}},
                                   {DOUBLE, {TP_AREA_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}},
                                   {PAIRS, {TP_AREA_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}},
                                   {DOUBLE, {TP_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}},
                                   {PAIRS, {TP_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}},
                                   {EXACT, {TP_AREA_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}},
                                   {EXACT, {TP_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}},
                                   {BALL, {TP_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1}}};
  enum { COUNT = sizeof methods / sizeof *methods };
  double per_vertex[COUNT];
  measure(per_vertex, in, methods, COUNT);
  printf("%9ld", in->count);
  print_numbers(per_vertex, 4);
  printf(" %6.2f %6.2f", per_vertex[2] / per_vertex[0], per_vertex[3] / per_vertex[0]);
  print_numbers(per_vertex + 4, COUNT - 4);
  printf("\n");
}

/* Area and centroid, then all six, in double and in pairs, by each of these plans. */
static void print_plan(const input *in, const char *name, tp_instructions set, int threads) {
  const method methods[] = {{DOUBLE, {TP_AREA_SUM_COUNT, set, threads}},
                            {PAIRS, {TP_AREA_SUM_COUNT, set, threads}},
                            {DOUBLE, {TP_SUM_COUNT, set, threads}},
                            {PAIRS, {TP_SUM_COUNT, set, threads}}};
  double per_vertex[4];
  measure(per_vertex, in, methods, 4);
  printf("%9ld %-10s", in->count, name);
  print_numbers(per_vertex, 4);
  printf("\n");
  fflush(stdout);
}

static void print_instruction_sets(const input *in) {
  static const char *const names[] = {"best", "baseline", "AVX2", "AVX-512"};
  for (int set = TP_INSTRUCTIONS_BASELINE; set < TP_INSTRUCTIONS_COUNT; set++) {
    if (tp_instructions_present(set)) print_plan(in, names[set], set, 1);
  }
}

static void print_threads(const input *in) {
  print_plan(in, "1 thread", TP_INSTRUCTIONS_BEST, 1);
  print_plan(in, "2 threads", TP_INSTRUCTIONS_BEST, 2);
  print_plan(in, "cores", TP_INSTRUCTIONS_BEST, 0);
}

/* A table's rows for some of the sizes. False without memory. */
static bool print_table(const char *head, void (*print)(const input *), const long *counts,
                        size_t size, long most) {
  printf("%s\n", head);
  for (size_t k = 0; k < size && counts[k] <= most; k++) {
    input in;
    if (!input_init(&in, counts[k])) {
      fprintf(stderr, "out of memory for %ld vertices\n", counts[k]);
      return false;
    }
    print(&in);
    input_clear(&in);
    fflush(stdout);
  }
  return true;
}

int main(int argc, char **argv) {
  const long most = argc > 1 ? bench_count(argv[1], 1000) : 10000000;
  if (argc > 2 || most == 0) {
    fprintf(stderr, "usage: bench_sums [MOST_VERTICES, at least 1000]\n");
    return 2;
  }
  static const long all[] = {5, 10, 20, 50, 100, 1000, 10000, 100000, 1000000, 10000000};
  static const long some[] = {100, 1000, 100000, 10000000}, large[] = {1000000, 10000000};
  const bool done =
      print_table("ns/vertex     read     loop  double3   pairs3  /read  /read  double6   pairs6"
                  "   exact3   exact6    ball6",
                  print_arithmetics, all, sizeof all / sizeof *all, most) &&
      print_table("\nns/vertex             double3   pairs3  double6   pairs6",
                  print_instruction_sets, some, sizeof some / sizeof *some, most) &&
      print_table("\nns/vertex             double3   pairs3  double6   pairs6", print_threads,
                  large, sizeof large / sizeof *large, most);
  flint_cleanup();
  return done ? 0 : BENCH_FAILED;
}
