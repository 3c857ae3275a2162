/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The kernels of outline_scan.h for one instruction set; included once for each. The includer
 * defines TARGET (the attribute that allows the instructions), KERNEL(name), WIDTH, FIRSTS and
 * SECONDS (the places of x and of y among 2 WIDTH numbers), LESSER(a, b), LARGER(a, b) and
 * EQUAL(a, b), a bit for every lane. No include guard: that is meant. */

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

/* Apart into x and y, and the first vertex once more, so often that vectors may read on. */
INLINE void KERNEL(part)(const tp_scan *scan, const double *xy) {
  double *const x = scan->x, *const y = scan->y;
  long k = 0;
  for (; k + WIDTH <= scan->count; k += WIDTH) {
    const VECTOR a = KERNEL(load)(xy + 2 * k), b = KERNEL(load)(xy + 2 * k + WIDTH);
    KERNEL(store)(x + k, __builtin_shufflevector(a, b, FIRSTS));
    KERNEL(store)(y + k, __builtin_shufflevector(a, b, SECONDS));
  }
  for (; k < scan->count; k++) {
    x[k] = xy[2 * k];
    y[k] = xy[2 * k + 1];
  }
  const VECTOR x0 = xy[0] + (VECTOR){0}, y0 = xy[1] + (VECTOR){0};
  for (long step = 0; step < BEYOND; step += WIDTH) {
    KERNEL(store)(x + scan->count + step, x0);
    KERNEL(store)(y + scan->count + step, y0);
  }
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
  KERNEL(part)(scan, xy);
  VECTOR least_x = KERNEL(load)(scan->x), most_x = least_x;
  VECTOR least_y = KERNEL(load)(scan->y), most_y = least_y;
  VECTOR least_sum = least_x + least_y, most_difference = least_x - least_y;
  for (long k = WIDTH; k < scan->count; k += WIDTH) {
    const VECTOR x = KERNEL(load)(scan->x + k), y = KERNEL(load)(scan->y + k);
    const VECTOR sum = x + y, difference = x - y;
    least_x = LESSER(least_x, x);
    most_x = LARGER(most_x, x);
    least_y = LESSER(least_y, y);
    most_y = LARGER(most_y, y);
    least_sum = LESSER(least_sum, sum);
    most_difference = LARGER(most_difference, difference);
  }
  scan->least_x = KERNEL(least)(least_x);
  scan->most_x = -KERNEL(least)(-most_x);
  scan->least_y = KERNEL(least)(least_y);
  scan->most_y = -KERNEL(least)(-most_y);
  const double sum = KERNEL(least)(least_sum), difference = -KERNEL(least)(-most_difference);
  scan->first = scan->last = -1;
  for (long k = 0; k < scan->count; k += WIDTH) {
    const VECTOR x = KERNEL(load)(scan->x + k), y = KERNEL(load)(scan->y + k);
    scan->first = KERNEL(find)(scan, scan->first, k, x + y, sum, 1);
    scan->last = KERNEL(find)(scan, scan->last, k, x - y, difference, -1);
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
