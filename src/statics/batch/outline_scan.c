/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The kernels of outline_scan.h from one source for every instruction set.
 *
 * Ends of the underside. Where x + y is least and x - y largest the underside ends as long as none
 * of it runs back (base/underside.h); both lie on the hull, so all of the outline may be searched
 * instead of its lower side. Rounding is monotone: of two vertices whose sums in doubles differ the
 * order is that of the true ones; of those alike, the errors of the sums, which are doubles
 * (Knuth), decide, and then which one lies further out.
 *
 * Turning. (N - P) . (F - N) has four rounded differences, two products and a sum: it errs by at
 * most 4.2 w (|level| + |upright|), w = 2^-53; what underflows is far less where that sum is at
 * least 1e-280. Where a factor of each product is 0, or the differences are exact and the products
 * cancel with their errors, it is exactly 0. */

#include "batch/outline_scan.h"

#include "number/binary.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __x86_64__
#include <immintrin.h>
#endif

/* Vertices that follow the last one, for vectors to read on. */
enum { BEYOND = 16 };

static const double turn_error = 0x1.4p-51, turn_least = 1e-280;

/* The error of the sum a + b in doubles. */
static double lost(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return (a - (sum - of_b)) + (b - of_b);
}

/* Of two vertices with the same x + side y in doubles, the one further out: of the least x + y the
 * left one, of the largest x - y the right one. */
static long tie_of(const tp_scan *scan, long one, long other, double side) {
  const double *x = scan->x, *y = scan->y;
  const double a = lost(x[one], side * y[one]), b = lost(x[other], side * y[other]);
  const bool takes_other = a != b ? (b < a) == (side > 0) : (x[other] < x[one]) == (side > 0);
  return takes_other ? other : one;
}

/* Where the chain goes on past the last vertex, those of the beginning follow it. */
static void wrap(const tp_scan *scan, tp_scan_chain c) {
  const long more = c.from + c.count + 1 - scan->count;
  if (more <= 1) return; /* the first one does anyway */
  memcpy(scan->x + scan->count, scan->x, (size_t)more * sizeof *scan->x);
  memcpy(scan->y + scan->count, scan->y, (size_t)more * sizeof *scan->y);
}

/* Facets of a chain, each from the end nearer to the pivot to the other one. */
typedef struct facets {
  const double *near_x, *near_y, *far_x, *far_y;
  long count;
  double pivot_x, pivot_y;
  double outwards; /* 1 or -1: away from the pivot along x */
} facets;

/* What the least of them come to. */
typedef struct turning {
  double ahead, product, certain;
} turning;

struct tp_scan_kernel {
  void (*read)(tp_scan *scan, const double *xy);
  void (*shift)(tp_scan *scan, double origin_x, double origin_y, double scale);
  turning (*turn)(const facets *facets);
};

/* Two lanes at a time, as every machine can. */
typedef double couple __attribute__((vector_size(16)));
typedef long long couple_bits __attribute__((vector_size(16)));

static inline __attribute__((always_inline)) double least_of(const double *lanes, int width) {
  couple least;
  memcpy(&least, lanes, sizeof least);
  for (int k = 2; k < width; k += 2) {
    couple other;
    memcpy(&other, lanes + k, sizeof other);
    const couple_bits below = other < least;
    least = (couple)(((couple_bits)other & below) | ((couple_bits)least & ~below));
  }
  return least[1] < least[0] ? least[1] : least[0];
}

#ifdef __x86_64__
#define KERNEL(name) avx512_##name
#define TARGET __attribute__((target("avx512f")))
#define WIDTH 8
#define FIRSTS 0, 2, 4, 6, 8, 10, 12, 14
#define SECONDS 1, 3, 5, 7, 9, 11, 13, 15
#define LESSER(a, b) ((VECTOR)_mm512_min_pd(a, b))
#define EQUAL(a, b) ((unsigned)_mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ))
#include "batch/outline_scan_in.h"

#define KERNEL(name) avx2_##name
#define TARGET __attribute__((target("avx2")))
#define WIDTH 4
#define FIRSTS 0, 2, 4, 6
#define SECONDS 1, 3, 5, 7
#define LESSER(a, b) ((VECTOR)_mm256_min_pd(a, b))
#define EQUAL(a, b) ((unsigned)_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_EQ_OQ)))
#include "batch/outline_scan_in.h"
#endif

#define KERNEL(name) baseline_##name
#define TARGET
#define WIDTH 2
#define FIRSTS 0, 2
#define SECONDS 1, 3
#define SELECT(first, a, b) ((VECTOR)(((BITS)(a) & (first)) | ((BITS)(b) & ~(first))))
#define LESSER(a, b) SELECT((a) < (b), a, b)
#define EQUAL(a, b) (((a)[0] == (b)[0] ? 1U : 0U) | ((a)[1] == (b)[1] ? 2U : 0U))
#include "batch/outline_scan_in.h"

const tp_scan_kernel *tp_scan_kernel_choose(tp_instructions instructions) {
  static const tp_scan_kernel kernels[] = {
      [TP_INSTRUCTIONS_BASELINE] = {baseline_read, baseline_shift, baseline_turn},
#ifdef __x86_64__
      [TP_INSTRUCTIONS_AVX2] = {avx2_read, avx2_shift, avx2_turn},
      [TP_INSTRUCTIONS_AVX512] = {avx512_read, avx512_shift, avx512_turn},
#endif
  };
  return kernels + tp_instructions_chosen(instructions);
}

bool tp_scan_read(tp_scan *scan, tp_workspace *workspace, tp_vertices vertices,
                  const tp_scan_kernel *kernel) {
  const size_t once = vertices.count + BEYOND, twice = vertices.count + once;
  if (vertices.count > SIZE_MAX / 64) return false;
  if (!tp_workspace_reserve(workspace, 2 * (once + twice))) return false;
  scan->count = (long)vertices.count;
  scan->x = workspace->room;
  scan->y = scan->x + twice;
  scan->u = scan->y + twice;
  scan->v = scan->u + once;
  kernel->read(scan, vertices.xy);
  return true;
}

void tp_scan_shift(tp_scan *scan, double origin_x, double origin_y, double scale,
                   const tp_scan_kernel *kernel) {
  kernel->shift(scan, origin_x, origin_y, scale);
}

/* The chain but for the facet at the pivot, whose near end that is: nothing keeps it from turning.
 */
static facets facets_of(const tp_scan *scan, tp_scan_chain c) {
  const double *x = scan->x + c.from + (c.forward ? 1 : 0);
  const double *y = scan->y + c.from + (c.forward ? 1 : 0);
  return (facets){.near_x = c.forward ? x : x + 1,
                  .near_y = c.forward ? y : y + 1,
                  .far_x = c.forward ? x + 1 : x,
                  .far_y = c.forward ? y + 1 : y,
                  .count = c.count - 1,
                  .pivot_x = scan->x[c.pivot],
                  .pivot_y = scan->y[c.pivot],
                  .outwards = c.rightwards ? 1 : -1};
}

/* Do the products cancel, all of it exact: is the facet at right angles to its arm? */
static bool is_upright(const facets *f, long k, double level, double upright) {
  const double arm_x = f->near_x[k] - f->pivot_x, arm_y = f->near_y[k] - f->pivot_y;
  const double run = f->far_x[k] - f->near_x[k], rise = f->far_y[k] - f->near_y[k];
  const bool exact = lost(f->near_x[k], -f->pivot_x) == 0 && lost(f->near_y[k], -f->pivot_y) == 0 &&
                     lost(f->far_x[k], -f->near_x[k]) == 0 && lost(f->far_y[k], -f->near_y[k]) == 0;
  return exact && level + upright == 0 && fma(arm_x, run, -level) + fma(arm_y, rise, -upright) == 0;
}

static tp_scan_answer turn_facet(const facets *f, long k) {
  const double arm_x = f->near_x[k] - f->pivot_x, arm_y = f->near_y[k] - f->pivot_y;
  const double run = f->far_x[k] - f->near_x[k], rise = f->far_y[k] - f->near_y[k];
  const double level = arm_x * run, upright = arm_y * rise, product = level + upright;
  const double size = fabs(level) + fabs(upright);
  if (f->outwards * run < 0) return TP_SCAN_OPEN;
  if ((arm_x == 0 || run == 0) && (arm_y == 0 || rise == 0)) return TP_SCAN_CLEAR;
  if (!(size >= turn_least)) return TP_SCAN_OPEN;
  if (fabs(product) < turn_error * size) {
    return is_upright(f, k, level, upright) ? TP_SCAN_CLEAR : TP_SCAN_OPEN;
  }
  return product < 0 ? TP_SCAN_BLOCKED : TP_SCAN_CLEAR;
}

/* One by one: few of them, or some that are exactly at right angles. */
static tp_scan_answer turn_each(const facets *f) {
  tp_scan_answer answer = TP_SCAN_CLEAR;
  for (long k = 0; k < f->count; k++) {
    const tp_scan_answer own = turn_facet(f, k);
    if (own == TP_SCAN_OPEN) return own;
    if (own == TP_SCAN_BLOCKED) answer = own;
  }
  return answer;
}

tp_scan_answer tp_scan_turn(const tp_scan *scan, tp_scan_chain chain,
                            const tp_scan_kernel *kernel) {
  enum { WIDEST = 8 };
  wrap(scan, chain);
  const facets f = facets_of(scan, chain);
  const double first_run =
      chain.forward ? f.near_x[0] - f.pivot_x : f.near_x[f.count - 1] - f.pivot_x;
  if (f.outwards * first_run < 0) return TP_SCAN_OPEN;
  if (f.count < WIDEST) return turn_each(&f);
  const turning all = kernel->turn(&f);
  if (all.ahead < 0) return TP_SCAN_OPEN;
  if (!(all.certain >= turn_least)) return turn_each(&f);
  return all.product < 0 ? TP_SCAN_BLOCKED : TP_SCAN_CLEAR;
}

double tp_scan_scale(const tp_scan *scan) {
  const double width = scan->most_x - scan->least_x, height = scan->most_y - scan->least_y;
  const double least = width < height ? width : height, most = width < height ? height : width;
  if (!(least >= 1e-100 && most <= 1e100 && most <= 1e50 * least)) return 0;
  return tp_two_to(3 - tp_binary_exponent(least));
}
