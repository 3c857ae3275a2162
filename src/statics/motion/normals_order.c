/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points sorted by the exact order of t . q within their families: doubles first where they
 * tell two apart, then words where all numbers are whole and short, as on a lattice, or balls. */

#define _GNU_SOURCE /* qsort_r */
#include "motion/normals_order.h"

#include "number/ball.h"
#include "number/binary.h"
#include "number/word.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* t below 2^25 and q up to 2^36: t . q is below 2^62. */
enum { SHORT_BITS = 25, WHOLE_BITS = 36 };

static int whole_order(fmpz a, fmpz b) {
  if (COEFF_IS_MPZ(a) || COEFF_IS_MPZ(b)) return fmpz_cmp(&a, &b);
  return (a > b) - (a < b);
}

static const tp_normal_place *place_of(const tp_normals_order *order, const tp_normal_entry *e) {
  return order->places + tp_normal_entry_point(e);
}

static int axis_order(const tp_normals_order *all, const tp_normal_entry *a,
                      const tp_normal_entry *b) {
  if (a->slope != b->slope) return a->slope < b->slope ? -1 : 1;
  if (tp_normal_entry_is_short(a) && tp_normal_entry_is_short(b)) return 0;
  const tp_normal_place *own = place_of(all, a), *other = place_of(all, b);
  const int order = whole_order(own->axis_x, other->axis_x);
  return order != 0 ? order : whole_order(own->axis_y, other->axis_y);
}

static int compare_balls(const void *left, const void *right, void *context) {
  const tp_normal_entry *own = left, *other = right;
  const tp_normals_order *all = context;
  const int axis = axis_order(all, own, other);
  if (axis != 0) return axis;
  const bool against = tp_normal_entry_is_against(own);
  if (against != tp_normal_entry_is_against(other)) return against ? -1 : 1;
  if (own->along.rounded != other->along.rounded) {
    return own->along.rounded < other->along.rounded ? -1 : 1;
  }
  const int along =
      arf_cmp(arb_midref(place_of(all, own)->along), arb_midref(place_of(all, other)->along));
  if (along != 0) return along;
  if (own->site != other->site) return own->site < other->site ? -1 : 1;
  return own->tag < other->tag ? -1 : own->tag > other->tag; /* by points */
}

static double slope_of(const fmpz *axis_x, const fmpz *axis_y) {
  if (fmpz_is_zero(axis_x)) return INFINITY;
  slong along, up;
  const double x = fmpz_get_d_2exp(&along, axis_x), y = fmpz_get_d_2exp(&up, axis_y);
  const slong most = 2000; /* beyond the exponents of doubles */
  const slong shift = up - along;
  return ldexp(y / x, (int)(shift > most ? most : shift < -most ? -most : shift));
}

static bool is_short(const fmpz *number) {
  return fmpz_bits(number) <= SHORT_BITS;
}

void tp_normals_order_direction(fmpz *tx, fmpz *ty, const tp_cones *cones, long point) {
  int64_t x, y;
  if (tp_word_small(&x, cones->tx + point) && tp_word_small(&y, cones->ty + point)) {
    const int64_t divisor = tp_word_gcd(x, y);
    tp_word_set(tx, x / divisor);
    tp_word_set(ty, y / divisor);
    return;
  }
  fmpz_t common;
  fmpz_init(common);
  fmpz_gcd(common, cones->tx + point, cones->ty + point);
  fmpz_divexact(tx, cones->tx + point, common);
  fmpz_divexact(ty, cones->ty + point, common);
  fmpz_clear(common);
}

/* Points with the t of each. */
typedef struct points {
  const tp_cones *cones;
  fmpz *tx, *ty;
} points;

static void points_init(points *p, const tp_cones *cones) {
  *p = (points){cones, _fmpz_vec_init(cones->count), _fmpz_vec_init(cones->count)};
  for (long k = 0; k < cones->count; k++) {
    if (k > 0 && tp_word_equal(cones->tx + k, cones->tx + k - 1) &&
        tp_word_equal(cones->ty + k, cones->ty + k - 1)) { /* both ends of a facet */
      fmpz_set(p->tx + k, p->tx + k - 1);
      fmpz_set(p->ty + k, p->ty + k - 1);
    } else {
      tp_normals_order_direction(p->tx + k, p->ty + k, cones, k);
    }
  }
}

static void points_clear(points *p) {
  _fmpz_vec_clear(p->tx, p->cones->count);
  _fmpz_vec_clear(p->ty, p->cones->count);
}

static bool is_whole(const points *p) {
  static const double most = (double)(INT64_C(1) << WHOLE_BITS);
  const tp_cones *cones = p->cones;
  if (cones->whole_x == NULL) return false;
  for (long k = 0; k < cones->count; k++) {
    if (!is_short(p->tx + k) || !is_short(p->ty + k) || fabs(cones->whole_x[k]) > most ||
        fabs(cones->whole_y[k]) > most) {
      return false;
    }
  }
  return true;
}

/* 1 or -1. */
static int sense_of(const fmpz *tx, const fmpz *ty) {
  const int along = fmpz_sgn(tx);
  return along != 0 ? along : fmpz_sgn(ty);
}

static uint32_t tag_of(long point, bool is_short, bool is_against) {
  return 4 * (uint32_t)point + 2 * is_short + is_against;
}

static void set_whole(tp_normal_entry *e, const points *p, long point) {
  const long tx = p->tx[point], ty = p->ty[point]; /* short */
  const bool is_against = tx < 0 || (tx == 0 && ty < 0);
  const double x = (double)(is_against ? -tx : tx), y = (double)(is_against ? -ty : ty);
  *e = (tp_normal_entry){.slope = tx == 0 ? INFINITY : y / x,
                         .site = p->cones->points[point].site,
                         .tag = tag_of(point, true, is_against)};
  e->along.whole = (int64_t)p->cones->whole_x[point] * tx + (int64_t)p->cones->whole_y[point] * ty;
}

/* t . q */
static void set_along(arb_t along, const points *p, long point, long precision) {
  const arb_struct x = tp_cones_x(p->cones, point), y = tp_cones_y(p->cones, point);
  arb_mul_fmpz(along, &x, p->tx + point, precision);
  arb_addmul_fmpz(along, &y, p->ty + point, precision);
}

static void set_balls(tp_normal_entry *e, tp_normal_place *place, const points *p, long point,
                      long precision) {
  const fmpz *tx = p->tx + point, *ty = p->ty + point;
  const int sense = sense_of(tx, ty);
  fmpz_mul_si(&place->axis_x, tx, sense);
  fmpz_mul_si(&place->axis_y, ty, sense);
  arb_init(place->along);
  set_along(place->along, p, point, precision);
  *e = (tp_normal_entry){.slope = slope_of(&place->axis_x, &place->axis_y),
                         .site = p->cones->points[point].site,
                         .tag = tag_of(point, is_short(tx) && is_short(ty), sense < 0)};
  e->along.rounded = tp_normals_top(arb_midref(place->along), 0);
}

static bool fill(tp_normals_order *order, const points *p, long precision) {
  const long count = p->cones->count;
  order->is_whole = is_whole(p);
  order->entries = calloc((size_t)count + 1, sizeof *order->entries);
  if (!order->is_whole) order->places = calloc((size_t)count + 1, sizeof *order->places);
  if (order->entries == NULL || (!order->is_whole && order->places == NULL)) return false;
  order->count = count;
  for (long k = 0; k < count; k++) {
    if (order->is_whole) {
      set_whole(order->entries + k, p, k);
    } else {
      set_balls(order->entries + k, order->places + k, p, k, precision);
    }
  }
  return true;
}

bool tp_normals_order_init(tp_normals_order *order, const tp_cones *cones, long precision) {
  points p;
  *order = (tp_normals_order){.count = 0};
  if (cones->count > INT32_MAX / 2) return false; /* a tag has four for each: beyond any memory */
  points_init(&p, cones);
  bool done = fill(order, &p, precision);
  points_clear(&p);
  if (done && order->is_whole) {
    done = tp_normals_order_by_families(order);
  } else if (done) {
    qsort_r(order->entries, (size_t)order->count, sizeof *order->entries, compare_balls, order);
  }
  if (!done) tp_normals_order_clear(order);
  return done;
}

void tp_normals_order_clear(tp_normals_order *order) {
  for (long k = 0; k < order->count && order->places != NULL; k++) {
    fmpz_clear(&order->places[k].axis_x);
    fmpz_clear(&order->places[k].axis_y);
    arb_clear(order->places[k].along);
  }
  free(order->entries);
  free(order->places);
  memset(order, 0, sizeof *order);
}

bool tp_normals_order_same_axis(const tp_normals_order *order, long k, long other) {
  const tp_normal_entry *a = order->entries + k, *b = order->entries + other;
  return order->is_whole ? a->slope == b->slope : axis_order(order, a, b) == 0;
}

int tp_normals_order_same_line(const tp_normals_order *order, long k, long other,
                               const tp_judge *judge) {
  const tp_normal_entry *one = order->entries + k, *two = order->entries + other;
  if (order->is_whole) return one->along.whole == two->along.whole;
  const tp_normal_place *a = place_of(order, one), *b = place_of(order, two);
  if (one->site == two->site) return 1;
  if (arb_is_exact(a->along) && arb_is_exact(b->along)) return arb_equal(a->along, b->along);
  arb_t gap;
  arb_init(gap);
  arb_sub(gap, a->along, b->along, judge->precision);
  tp_vector size;
  tp_vector_init(&size);
  arb_set(size.of, a->along);
  const int sign = tp_judge_sign(judge, gap, tp_vector_log2_size(&size));
  tp_vector_clear(&size);
  arb_clear(gap);
  return sign == TP_OPEN_SIGN ? TP_OPEN_SIGN : sign == 0;
}

/* As tp_normals_near does with balls: over the power of two next above the largest. */
static void set_near(double near[3], const int64_t h[3]) {
  uint64_t all = 0;
  for (int k = 0; k < 3; k++) all |= (uint64_t)llabs(h[k]);
  const double unit = tp_two_to(all == 0 ? 0 : __builtin_clzll(all) - 64);
  for (int k = 0; k < 3; k++) near[k] = (double)h[k] * unit;
}

void tp_normals_order_near(double near[3], const tp_normals_order *order, long k,
                           const tp_contact_family *family) {
  const tp_normal_entry *e = order->entries + k;
  if (order->is_whole) {
    set_near(near, (int64_t[3]){-family->ty, family->tx, e->along.whole});
    return;
  }
  tp_vector h;
  tp_vector_init(&h);
  arb_set_fmpz(h.of, &family->ty);
  arb_neg(h.of, h.of);
  arb_set_fmpz(h.of + 1, &family->tx);
  arb_set(h.of + 2, place_of(order, e)->along);
  tp_normals_near(near, &h);
  tp_vector_clear(&h);
}
