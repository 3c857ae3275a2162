/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moment sums in their three arithmetics beside a plain read of the same coordinates.
 *
 *     bench_sums [MOST_VERTICES]
 *
 * Measured: tp_ring_sums_double, tp_ring_sums_exact and tp_ring_sums_ball at 128 bits on the rough
 * outline of bench.h, and a sum over both arrays, which reads every byte of them and does next to
 * nothing else; medians of 9 samples, the kernels in turn, each sample repeated to last 5 ms.
 * To be read: `ratio` is double over read, what the sums cost beyond fetching their input. It is
 * large where the coordinates lie in cache and falls as memory becomes the limit. Exact and ball
 * are left out beyond 10^5 vertices. */

#include "bench.h"

#include "block/ring_sums.h"

enum { SAMPLES = 9, KERNELS = 4, LANES = 8, BALL_BITS = 128, MOST_SLOW = 100000 };

typedef struct input {
  long count;
  double *u, *v;
  fmpz *x, *y; /* NULL beyond MOST_SLOW vertices */
} input;

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

static void sum_double(const input *in) {
  double sums[TP_SUM_COUNT], bounds[TP_SUM_COUNT];
  tp_ring_sums_double(sums, bounds, in->u, in->v, in->count, true);
  sink = sums[TP_A2] + bounds[TP_A2];
}

static void sum_exactly(const input *in) {
  fmpz sums[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_init(sums + k);
  tp_ring_sums_exact(sums, in->x, in->y, in->count);
  sink = fmpz_get_d(sums + TP_A2);
  for (int k = 0; k < TP_SUM_COUNT; k++) fmpz_clear(sums + k);
}

static void sum_in_balls(const input *in) {
  arb_struct sums[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_init(sums + k);
  tp_ring_sums_ball(sums, in->x, in->y, in->count, BALL_BITS);
  sink = arf_get_d(arb_midref(sums + TP_A2), ARF_RND_NEAR);
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_clear(sums + k);
}

typedef void (*kernel)(const input *in);
static const kernel kernels[KERNELS] = {read_plainly, sum_double, sum_exactly, sum_in_balls};

static double seconds_of(kernel run, const input *in, long repeats) {
  const double began = bench_now();
  for (long k = 0; k < repeats; k++) run(in);
  return bench_now() - began;
}

/* How often a kernel has to run for 5 ms; warms the caches up as well. */
static long repeats_of(kernel run, const input *in) {
  long repeats = 1;
  while (seconds_of(run, in, repeats) < 5e-3) repeats *= 2;
  return repeats;
}

/* Nanoseconds per vertex of the first `used` kernels. */
static void measure(double per_vertex[KERNELS], const input *in, int used) {
  double samples[KERNELS][SAMPLES];
  long repeats[KERNELS];
  for (int k = 0; k < used; k++) repeats[k] = repeats_of(kernels[k], in);
  for (int s = 0; s < SAMPLES; s++) {
    for (int k = 0; k < used; k++) {
      const double seconds = seconds_of(kernels[k], in, repeats[k]);
      samples[k][s] = 1e9 * seconds / ((double)repeats[k] * (double)in->count);
    }
  }
  for (int k = 0; k < used; k++) per_vertex[k] = bench_median(samples[k], SAMPLES);
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
  bench_outline(in->u, in->v, in->count);
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

static void print_row(const input *in, const double *per_vertex) {
  printf("%9ld %15.3f %17.3f %7.2f", in->count, per_vertex[0], per_vertex[1],
         per_vertex[1] / per_vertex[0]);
  if (in->x != NULL) {
    printf(" %16.1f %15.1f\n", per_vertex[2], per_vertex[3]);
  } else {
    printf(" %16s %15s\n", "-", "-");
  }
  fflush(stdout);
}

int main(int argc, char **argv) {
  const long most = argc > 1 ? bench_count(argv[1], 1000) : 10000000;
  if (argc > 2 || most == 0) {
    fprintf(stderr, "usage: bench_sums [MOST_VERTICES, at least 1000]\n");
    return 2;
  }
  printf("%9s %15s %17s %7s %16s %15s\n", "vertices", "read ns/vertex", "double ns/vertex", "ratio",
         "exact ns/vertex", "ball ns/vertex");
  for (long count = 1000; count <= most; count *= 10) {
    input in;
    double per_vertex[KERNELS] = {0};
    if (!input_init(&in, count)) {
      fprintf(stderr, "out of memory for %ld vertices\n", count);
      return BENCH_FAILED;
    }
    measure(per_vertex, &in, in.x != NULL ? KERNELS : 2);
    print_row(&in, per_vertex);
    input_clear(&in);
  }
  flint_cleanup();
  return 0;
}
