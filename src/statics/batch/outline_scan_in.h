/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The kernels of outline_scan.h for one instruction set; included once for each. The includer
 * defines TARGET (the attribute that allows the instructions), KERNEL(name), WIDTH, FIRSTS and
 * SECONDS (the places of x and of y among 2 WIDTH numbers), LESSER(a, b) and EQUAL(a, b), a bit for
 * every lane; all of these end with this file. No include guard: that is meant. */

#define INLINE static inline __attribute__((always_inline)) TARGET
#define VECTOR KERNEL(vector)
#define BITS KERNEL(bits)

typedef double VECTOR __attribute__((vector_size(8 * WIDTH)));
typedef long long BITS __attribute__((vector_size(8 * WIDTH)));

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

INLINE double KERNEL(least)(VECTOR v) {
  double lanes[WIDTH];
  KERNEL(store)(lanes, v);
  return least_of(lanes, WIDTH);
}

/* What is gathered over the vertices, lane by lane; of the largest its negative. */
typedef struct KERNEL(extremes) {
  VECTOR left, right, low, high, first, last;
} KERNEL(extremes);

INLINE void KERNEL(gather)(KERNEL(extremes) * all, VECTOR x, VECTOR y) {
  all->left = LESSER(all->left, x);
  all->right = LESSER(all->right, -x);
  all->low = LESSER(all->low, y);
  all->high = LESSER(all->high, -y);
  all->first = LESSER(all->first, x + y);
  all->last = LESSER(all->last, y - x);
}

/* WIDTH vertices from the k-th on apart, and gathered. */
INLINE void KERNEL(part)(KERNEL(extremes) * all, const tp_scan *scan, const double *xy, long k) {
  const VECTOR a = KERNEL(load)(xy + 2 * k), b = KERNEL(load)(xy + 2 * k + WIDTH);
  const VECTOR x = __builtin_shufflevector(a, b, FIRSTS);
  const VECTOR y = __builtin_shufflevector(a, b, SECONDS);
  KERNEL(store)(scan->x + k, x);
  KERNEL(store)(scan->y + k, y);
  KERNEL(gather)(all, x, y);
}

/* The first vertex follows the last one, so often that vectors may read on. */
INLINE void KERNEL(close)(const tp_scan *scan, const double *xy) {
  const VECTOR x = xy[0] + (VECTOR){0}, y = xy[1] + (VECTOR){0};
  for (long step = 0; step < BEYOND; step += WIDTH) {
    KERNEL(store)(scan->x + scan->count + step, x);
    KERNEL(store)(scan->y + scan->count + step, y);
  }
}

/* All vertices; the last ones are taken twice where they fill no vector. */
INLINE KERNEL(extremes) KERNEL(part_all)(const tp_scan *scan, const double *xy) {
  const VECTOR none = INFINITY + (VECTOR){0};
  KERNEL(extremes) all = {none, none, none, none, none, none};
  const long count = scan->count;
  KERNEL(close)(scan, xy);
  if (count < WIDTH) {
    for (long k = 0; k < count; k++) {
      scan->x[k] = xy[2 * k];
      scan->y[k] = xy[2 * k + 1];
    }
    KERNEL(gather)(&all, KERNEL(load)(scan->x), KERNEL(load)(scan->y));
    return all;
  }
  for (long k = 0; k + WIDTH <= count; k += WIDTH) KERNEL(part)(&all, scan, xy, k);
  if (count % WIDTH != 0) KERNEL(part)(&all, scan, xy, count - WIDTH);
  return all;
}

/* Those among the next WIDTH vertices that are as far out as `extreme`: the best of them and of
 * `found`. */
INLINE long KERNEL(find)(const tp_scan *scan, long found, long k, VECTOR own, double extreme,
                         double side) {
  unsigned hits = EQUAL(own, extreme + (VECTOR){0});
  for (; hits != 0; hits &= hits - 1) {
    const long next = k + __builtin_ctz(hits);
    if (next < scan->count) found = found < 0 ? next : tie_of(scan, found, next, side);
  }
  return found;
}

static TARGET void KERNEL(read)(tp_scan *scan, const double *xy) {
  const KERNEL(extremes) all = KERNEL(part_all)(scan, xy);
  scan->least_x = KERNEL(least)(all.left);
  scan->most_x = -KERNEL(least)(all.right);
  scan->least_y = KERNEL(least)(all.low);
  scan->most_y = -KERNEL(least)(all.high);
  const double first = KERNEL(least)(all.first), last = KERNEL(least)(all.last);
  scan->first = scan->last = -1;
  for (long k = 0; k < scan->count; k += WIDTH) {
    const VECTOR x = KERNEL(load)(scan->x + k), y = KERNEL(load)(scan->y + k);
    scan->first = KERNEL(find)(scan, scan->first, k, y + x, first, 1);
    scan->last = KERNEL(find)(scan, scan->last, k, y - x, last, -1);
  }
}

static TARGET void KERNEL(shift)(tp_scan *scan, double origin_x, double origin_y, double scale) {
  for (long k = 0; k < scan->count; k += WIDTH) {
    KERNEL(store)(scan->u + k, (KERNEL(load)(scan->x + k) - origin_x) * scale);
    KERNEL(store)(scan->v + k, (KERNEL(load)(scan->y + k) - origin_y) * scale);
  }
}

/* The least of `ahead`, of (N - P) . (F - N) and of what is left of its size beyond its error,
 * over `count` facets, WIDTH of them at least: the last ones are taken twice where they fill no
 * vector. */
static TARGET turning KERNEL(turn)(const facets *f) {
  VECTOR ahead = INFINITY + (VECTOR){0}, product = ahead, certain = ahead;
  for (long k = 0; k < f->count; k += WIDTH) {
    const long at = k + WIDTH <= f->count ? k : f->count - WIDTH;
    const VECTOR nx = KERNEL(load)(f->near_x + at), ny = KERNEL(load)(f->near_y + at);
    const VECTOR run = KERNEL(load)(f->far_x + at) - nx, rise = KERNEL(load)(f->far_y + at) - ny;
    const VECTOR level = (nx - f->pivot_x) * run, upright = (ny - f->pivot_y) * rise;
    const VECTOR own = level + upright;
    const VECTOR error = turn_error * (KERNEL(absolute)(level) + KERNEL(absolute)(upright));
    ahead = LESSER(ahead, f->outwards * run);
    product = LESSER(product, own);
    certain = LESSER(certain, KERNEL(absolute)(own) - error);
  }
  return (turning){KERNEL(least)(ahead), KERNEL(least)(product), KERNEL(least)(certain)};
}

#undef INLINE
#undef VECTOR
#undef BITS
#undef KERNEL
#undef TARGET
#undef WIDTH
#undef FIRSTS
#undef SECONDS
#undef LESSER
#undef EQUAL
