/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vectors of WIDTH lanes, for the kernels of one instruction set; included once for each. The
 * includer defines TARGET (the attribute that allows the instructions), KERNEL(name), WIDTH, INDEX
 * (0, 1, … WIDTH - 1), LARGER(a, b), LOAD_FIRST(values, count) (the lanes from `count` on are 0 and
 * not read) and, where the machine has a fused product, PRODUCT_LESS(a, b, p) = a b - p rounded
 * once. No include guard: that is meant. */

#define INLINE static inline __attribute__((always_inline)) TARGET
#define VECTOR KERNEL(vector)
#define BITS KERNEL(bits)
#define PAIR KERNEL(pair)

typedef double VECTOR __attribute__((vector_size(8 * WIDTH)));
typedef long long BITS __attribute__((vector_size(8 * WIDTH)));

/* The unevaluated sum of two vectors. */
typedef struct PAIR {
  VECTOR high, low;
} PAIR;

INLINE VECTOR KERNEL(load)(const double *values) {
  VECTOR v;
  memcpy(&v, values, sizeof v);
  return v;
}

INLINE void KERNEL(store)(double *values, VECTOR v) {
  memcpy(values, &v, sizeof v);
}

INLINE VECTOR KERNEL(absolute)(VECTOR v) {
  return (VECTOR)((BITS)v & 0x7fffffffffffffff);
}

/* At most `left` values, the first ends of the last edges; 0 beyond. */
INLINE VECTOR KERNEL(load_first)(const double *values, long left) {
  return LOAD_FIRST(values, left < WIDTH ? left : WIDTH);
}

/* Their second ends: the last of `left` edges ends in `end`. */
INLINE VECTOR KERNEL(load_second)(const double *values, long left, double end) {
  const VECTOR all = end + (VECTOR){0};
  const BITS last = (BITS){INDEX} == (left - 1);
  const VECTOR others = KERNEL(load_first)(values + 1, left - 1);
  return (VECTOR)((BITS)others | (last & (BITS)all));
}

/* a + b exactly (Knuth). */
INLINE PAIR KERNEL(two_sum)(VECTOR a, VECTOR b) {
  const VECTOR sum = a + b, of_b = sum - a;
  return (PAIR){sum, (a - (sum - of_b)) + (b - of_b)};
}

#ifndef PRODUCT_LESS
/* Veltkamp's halves of 26 bits, whose products are exact. */
INLINE PAIR KERNEL(halves)(VECTOR a) {
  const VECTOR t = 0x8000001 * a, high = t - (t - a);
  return (PAIR){high, a - high};
}
#endif

/* a b exactly: by a fused product or by Dekker's, the same bits. */
INLINE PAIR KERNEL(two_product)(VECTOR a, VECTOR b) {
  const VECTOR p = a * b;
#ifdef PRODUCT_LESS
  return (PAIR){p, PRODUCT_LESS(a, b, p)};
#else
  const PAIR x = KERNEL(halves)(a), y = KERNEL(halves)(b);
  return (PAIR){p, x.low * y.low - (((p - x.high * y.high) - x.low * y.high) - x.high * y.low)};
#endif
}

/* One row of partial sums into another, by what the row means (ring_sums_kernel.h). */
INLINE void KERNEL(join)(lane_rows *rows, const lane_rows *others, int sum_count, bool pairs) {
  for (int lane = 0; lane < TP_LANES; lane += WIDTH) {
    for (int k = TP_ROW_MOST_U; k <= TP_ROW_MOST_V; k++) {
      double *row = rows->row[k] + lane;
      KERNEL(store)(row, LARGER(KERNEL(load)(row), KERNEL(load)(others->row[k] + lane)));
    }
    for (int k = TP_ROW_MEASURES; k < TP_ROW_SUMS + (pairs ? 0 : sum_count); k++) {
      double *row = rows->row[k] + lane;
      KERNEL(store)(row, KERNEL(load)(row) + KERNEL(load)(others->row[k] + lane));
    }
    for (int k = TP_ROW_SUMS; k < TP_ROW_SUMS + (pairs ? 2 * sum_count : 0); k += 2) {
      double *high = rows->row[k] + lane, *low = rows->row[k + 1] + lane;
      const VECTOR other = KERNEL(load)(others->row[k + 1] + lane);
      const PAIR sum = KERNEL(two_sum)(KERNEL(load)(high), KERNEL(load)(others->row[k] + lane));
      KERNEL(store)(high, sum.high);
      KERNEL(store)(low, KERNEL(load)(low) + (sum.low + other));
    }
  }
}
