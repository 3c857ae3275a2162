/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The kernels of the fast sums, from one source for every instruction set, and which one runs.
 *
 * Each set has registers of its own width and the same operations in the same order on every lane.
 * What differs is exact: the larger of two numbers, and the error of a product. */

#include "block/ring_sums_kernel.h"

#include <float.h>
#include <string.h>

#ifdef __x86_64__
#include <immintrin.h>
#endif

/* The error-free transformations, and the same bits everywhere, need double to be double. */
_Static_assert(FLT_EVAL_METHOD == 0, "double arithmetic is done in another precision");

enum { BLOCK_LEVELS = 10 };
_Static_assert(TP_BLOCK_EDGES / TP_CHUNK_EDGES == 1 << (BLOCK_LEVELS - 1), "levels of a block");

/* What is gathered, lane by lane. */
typedef struct lane_rows {
  _Alignas(64) double row[TP_ROW_COUNT][TP_LANES];
} lane_rows;

/* `count` edges; of the first `whole`, a multiple of TP_LANES, the second ends follow in memory. */
typedef struct span {
  const double *u, *v;
  long count, whole;
  double end_u, end_v;       /* where the last edge of the ring ends */
  double before_u, before_v; /* where the edge before the first begins */
} span;

static inline span span_of(const tp_ring *ring, long first, long count) {
  const bool closes = first + count == ring->count;
  const long before = (first > 0 ? first : ring->count) - 1;
  return (span){.u = ring->u + first,
                .v = ring->v + first,
                .count = count,
                .whole = (closes ? count - 1 : count) / TP_LANES * TP_LANES,
                .end_u = ring->u[0],
                .end_v = ring->v[0],
                .before_u = ring->u[before],
                .before_v = ring->v[before]};
}

/* Two lanes at a time, as every machine can. */
typedef double couple __attribute__((vector_size(16)));
typedef long long couple_bits __attribute__((vector_size(16)));

static inline couple load_couple(const double *values) {
  couple c;
  memcpy(&c, values, sizeof c);
  return c;
}

static inline void join_couple(couple high[1], couple low[1], couple other, couple other_low) {
  const couple sum = *high + other, of_other = sum - *high;
  const couple lost = (*high - (sum - of_other)) + (other - of_other);
  *high = sum;
  *low += lost + other_low;
}

/* Lanes k and k + 4, then k and k + 2: what is left are two. */
static inline couple last_two(const double *lanes) {
  const couple even = load_couple(lanes) + load_couple(lanes + 4),
               odd = load_couple(lanes + 2) + load_couple(lanes + 6);
  return even + odd;
}

static inline couple larger(couple a, couple b) {
  const couple_bits above = a > b;
  return (couple)(((couple_bits)a & above) | ((couple_bits)b & ~above));
}

static inline couple largest_two(const double *lanes) {
  return larger(larger(load_couple(lanes), load_couple(lanes + 4)),
                larger(load_couple(lanes + 2), load_couple(lanes + 6)));
}

/* The first of both, and the second. */
static inline couple firsts(couple a, couple b) {
  return (couple){a[0], b[0]};
}

static inline couple seconds(couple a, couple b) {
  return (couple){a[1], b[1]};
}

static inline void store_couple(double *values, couple c) {
  memcpy(values, &c, sizeof c);
}

/* Two rows at a time, stored as one: who reads them next need not wait for two stores. */
static inline void join_sums(double rows[2], const double *lanes) {
  const couple a = last_two(lanes), b = last_two(lanes + TP_LANES);
  store_couple(rows, firsts(a, b) + seconds(a, b));
}

static inline void join_largest(double rows[2], const double *lanes) {
  const couple a = largest_two(lanes), b = largest_two(lanes + TP_LANES);
  store_couple(rows, larger(firsts(a, b), seconds(a, b)));
}

/* A row of high parts and the next one, of the low ones. */
static inline void join_pairs(double rows[2], const double *lanes) {
  const double *const lower = lanes + TP_LANES;
  couple a = load_couple(lanes), a_low = load_couple(lower), b = load_couple(lanes + 2),
         b_low = load_couple(lower + 2);
  join_couple(&a, &a_low, load_couple(lanes + 4), load_couple(lower + 4));
  join_couple(&b, &b_low, load_couple(lanes + 6), load_couple(lower + 6));
  join_couple(&a, &a_low, b, b_low);
  join_couple(&a, &a_low, (couple){a[1], 0}, (couple){a_low[1], 0});
  store_couple(rows, firsts(a, a_low));
}

static inline __attribute__((always_inline)) void
join_lanes(double rows[TP_ROW_COUNT], const lane_rows *lanes, int sum_count, bool pairs) {
  join_largest(rows + TP_ROW_MOST_U, lanes->row[TP_ROW_MOST_U]);
  join_sums(rows + TP_ROW_MEASURES, lanes->row[TP_ROW_MEASURES]);
  for (int k = TP_ROW_SUMS; k < TP_ROW_SUMS + (pairs ? 2 * sum_count : 0); k += 2) {
    join_pairs(rows + k, lanes->row[k]);
  }
  for (int k = TP_ROW_SUMS; k < TP_ROW_SUMS + (pairs ? 0 : sum_count); k += 2) {
    if (k + 1 < TP_ROW_SUMS + sum_count) {
      join_sums(rows + k, lanes->row[k]);
    } else {
      const couple last = last_two(lanes->row[k]);
      rows[k] = last[0] + last[1];
    }
  }
}

#ifdef __x86_64__
#define KERNEL(name) avx512_##name
#define TARGET __attribute__((target("avx512f")))
#define WIDTH 8
#define INDEX 0, 1, 2, 3, 4, 5, 6, 7
#define LARGER(a, b) ((VECTOR)_mm512_max_pd(a, b))
#define LOAD_FIRST(values, count)                                                                  \
  ((VECTOR)_mm512_maskz_loadu_pd((__mmask8)((1U << (count)) - 1), values))
#define PRODUCT_LESS(a, b, p) ((VECTOR)_mm512_fmsub_pd(a, b, p))
#include "block/ring_sums_block_in.h"
#undef KERNEL
#undef TARGET
#undef WIDTH
#undef INDEX
#undef LARGER
#undef LOAD_FIRST
#undef PRODUCT_LESS

#define KERNEL(name) avx2_##name
#define TARGET __attribute__((target("avx2,fma")))
#define WIDTH 4
#define INDEX 0, 1, 2, 3
#define LARGER(a, b) ((VECTOR)_mm256_max_pd(a, b))
#define LOAD_FIRST(values, count)                                                                  \
  ((VECTOR)_mm256_maskload_pd(values, (__m256i)((BITS){INDEX} < (count))))
#define PRODUCT_LESS(a, b, p) ((VECTOR)_mm256_fmsub_pd(a, b, p))
#include "block/ring_sums_block_in.h"
#undef KERNEL
#undef TARGET
#undef WIDTH
#undef INDEX
#undef LARGER
#undef LOAD_FIRST
#undef PRODUCT_LESS
#endif

/* What every machine has: two lanes, fused products only where the whole build may use them. */
#define KERNEL(name) baseline_##name
#define TARGET
#define WIDTH 2
#define INDEX 0, 1
#ifdef __x86_64__
#define LARGER(a, b) ((VECTOR)_mm_max_pd(a, b))
#else
#define LARGER(a, b) ((VECTOR)(((BITS)(a) & ((a) > (b))) | ((BITS)(b) & ~((a) > (b)))))
#endif
#define LOAD_FIRST(values, count)                                                                  \
  ((VECTOR){(count) > 0 ? (values)[0] : 0, (count) > 1 ? (values)[1] : 0})
#ifdef __FP_FAST_FMA
#define PRODUCT_LESS(a, b, p)                                                                      \
  ((VECTOR){__builtin_fma((a)[0], (b)[0], -(p)[0]), __builtin_fma((a)[1], (b)[1], -(p)[1])})
#endif
#include "block/ring_sums_block_in.h"

tp_ring_kernel tp_ring_kernel_choose(tp_sums_plan plan, bool pairs) {
  static const tp_ring_kernel kernels[][2][2] = {
      [TP_INSTRUCTIONS_BASELINE] = {{baseline_plain_area, baseline_plain_all},
                                    {baseline_pair_area, baseline_pair_all}},
#ifdef __x86_64__
      [TP_INSTRUCTIONS_AVX2] = {{avx2_plain_area, avx2_plain_all}, {avx2_pair_area, avx2_pair_all}},
      [TP_INSTRUCTIONS_AVX512] = {{avx512_plain_area, avx512_plain_all},
                                  {avx512_pair_area, avx512_pair_all}},
#endif
  };
  const tp_instructions set = tp_instructions_chosen(plan.instructions);
  return kernels[set][pairs][plan.sum_count == TP_SUM_COUNT];
}
