/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The kernels of front.h for one instruction set; included once for each. The includer defines
 * TARGET (the attribute that allows the instructions), KERNEL(name) and LANES, how many doubles a
 * vector of its has; these end with this file. Each entry is the same sums in the same order in all
 * of them, without fused products, so that every machine has the same bits. No include guard: that
 * is meant. */

#define INLINE static inline __attribute__((always_inline)) TARGET

/* c -= a b^T, of `count` columns of a and b, three by three vectors of c at a time. */
#define TAKE(name, type)                                                                           \
  INLINE void KERNEL(name)(double *restrict c, long step, const double *restrict a,                \
                           const double *restrict b, long rows, long count) {                      \
    type sum[WIDE][WIDE] = {0};                                                                    \
    for (long k = 0; k < count; k++, a += rows, b += rows) {                                       \
      type own[WIDE];                                                                              \
      memcpy(own, a, sizeof own);                                                                  \
      _Pragma("GCC unroll 3") for (int j = 0; j < WIDE; j++) {                                     \
        _Pragma("GCC unroll 3") for (int i = 0; i < WIDE; i++) sum[j][i] += own[i] * b[j];         \
      }                                                                                            \
    }                                                                                              \
    for (int j = 0; j < WIDE; j++) {                                                               \
      type own[WIDE];                                                                              \
      memcpy(own, c + j * step, sizeof own);                                                       \
      for (int i = 0; i < WIDE; i++) own[i] -= sum[j][i];                                          \
      memcpy(c + j * step, own, sizeof own);                                                       \
    }                                                                                              \
  }
TAKE(take_1, double)
#if LANES >= 2
TAKE(take_2, two_lanes)
#endif
#if LANES >= 4
TAKE(take_4, four_lanes)
#endif
#if LANES >= 8
TAKE(take_8, eight_lanes)
#endif

#define TAKE_ROWS(lanes)                                                                           \
  for (; i + WIDE * (lanes) <= rows; i += WIDE * (lanes))                                          \
  KERNEL(take_##lanes)(own + i, step, stripe + i, stripe + j, rows, count)

/* From the columns top … end - 1 of `target`, whose first row is row `top` of the stripe, on and
 * below the diagonal. */
TARGET static void KERNEL(take_all)(double *target, long step, const double *stripe, long rows,
                                    long count, long top, long end) {
  for (long j = top; j < end; j += WIDE) {
    double *own = target + (j - top) * step - top;
    long i = j;
#if LANES >= 8
    TAKE_ROWS(8);
#endif
#if LANES >= 4
    TAKE_ROWS(4);
#endif
#if LANES >= 2
    TAKE_ROWS(2);
#endif
    TAKE_ROWS(1);
  }
}

/* Columns first … end - 1, from the diagonal down. */
TARGET static bool KERNEL(factorise_few)(double *columns, long rows, long first, long end) {
  for (long j = first; j < end; j++) {
    double *restrict own = columns + j * rows;
    for (long k = first; k < j; k++) {
      const double *restrict other = columns + k * rows;
      const double share = other[j];
      for (long i = j; i < rows; i++) own[i] -= share * other[i];
    }
    if (!(own[j] > 0 && isfinite(own[j]))) return false;
    const double over = 1 / sqrt(own[j]);
    for (long i = j; i < rows; i++) own[i] *= over;
  }
  return true;
}

TARGET static bool KERNEL(factorise_stripe)(double *columns, long rows, long first, long end) {
  for (long at = first; at < end; at += NARROW) {
    const long next = at + NARROW < end ? at + NARROW : end;
    if (!KERNEL(factorise_few)(columns, rows, at, next)) return false;
    KERNEL(take_all)
    (columns + next * rows + next, rows, columns + at * rows, rows, next - at, next, end);
  }
  return true;
}

TARGET static bool KERNEL(factorise)(double *columns, long rows, long own, double *rest) {
  for (long first = 0; first < own; first += STRIPE) {
    const long end = first + STRIPE < own ? first + STRIPE : own;
    const double *stripe = columns + first * rows;
    if (!KERNEL(factorise_stripe)(columns, rows, first, end)) return false;
    KERNEL(take_all)(columns + end * rows + end, rows, stripe, rows, end - first, end, own);
    KERNEL(take_all)(rest, rows - own, stripe, rows, end - first, own, rows);
  }
  return true;
}

/* Three columns at a time: they take turns only within the square at their diagonal. */
TARGET static void KERNEL(solve)(double *restrict v, const double *restrict columns, long rows,
                                 long own) {
  for (long j = 0; j < own; j += WIDE) {
    const double *a = columns + j * rows, *b = a + rows, *c = b + rows;
    const double x = v[j] /= a[j];
    const double y = v[j + 1] = (v[j + 1] - x * a[j + 1]) / b[j + 1];
    const double z = v[j + 2] = (v[j + 2] - x * a[j + 2] - y * b[j + 2]) / c[j + 2];
    long i = j + WIDE;
    for (; i + SUMS <= rows; i += SUMS) {
      __builtin_prefetch(a + i + WIDE * rows);
      __builtin_prefetch(b + i + WIDE * rows);
      __builtin_prefetch(c + i + WIDE * rows);
      for (int k = 0; k < SUMS; k++) v[i + k] -= x * a[i + k] + y * b[i + k] + z * c[i + k];
    }
    for (; i < rows; i++) v[i] -= x * a[i] + y * b[i] + z * c[i];
  }
}

TARGET static void KERNEL(solve_back)(double *restrict v, const double *restrict columns, long rows,
                                      long own) {
  for (long j = own - WIDE; j >= 0; j -= WIDE) {
    const double *a = columns + j * rows, *b = a + rows, *c = b + rows;
    double x[SUMS] = {0}, y[SUMS] = {0}, z[SUMS] = {0};
    long i = j + WIDE;
    for (; i + SUMS <= rows; i += SUMS) {
      __builtin_prefetch(a + i - WIDE * rows);
      __builtin_prefetch(b + i - WIDE * rows);
      __builtin_prefetch(c + i - WIDE * rows);
      for (int k = 0; k < SUMS; k++) x[k] += a[i + k] * v[i + k];
      for (int k = 0; k < SUMS; k++) y[k] += b[i + k] * v[i + k];
      for (int k = 0; k < SUMS; k++) z[k] += c[i + k] * v[i + k];
    }
    for (int k = 0; i < rows; i++, k++) {
      x[k] += a[i] * v[i];
      y[k] += b[i] * v[i];
      z[k] += c[i] * v[i];
    }
    v[j + 2] = (v[j + 2] - sum_of(z)) / c[j + 2];
    v[j + 1] = (v[j + 1] - sum_of(y) - b[j + 2] * v[j + 2]) / b[j + 1];
    v[j] = (v[j] - sum_of(x) - a[j + 1] * v[j + 1] - a[j + 2] * v[j + 2]) / a[j];
  }
}

static const tp_front_kernel KERNEL(kernel) = {KERNEL(factorise), KERNEL(solve),
                                               KERNEL(solve_back)};

#undef INLINE
#undef TAKE
#undef TAKE_ROWS
#undef KERNEL
#undef TARGET
#undef LANES
