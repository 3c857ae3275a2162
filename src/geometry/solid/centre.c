/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heights and arms in doubles with bounds; in whole numbers, M and 4 V6 in place of their quotient,
 * where these do not tell. */

#include "solid/centre.h"

#include "common/host.h"

#include <flint/fmpq.h>

/* number * 2^shift; `tp_near` has no room for what lies beyond the range of doubles, and says so by
 * an infinite error. */
static tp_near near_of_whole(const fmpz_t number, long shift) {
  if (fmpz_is_zero(number)) return (tp_near){0, 0};
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, number);
  const long at = exponent + shift;
  if (at > 1000 || at < -1000) return (tp_near){0, INFINITY};
  const double value = ldexp(mantissa, (int)at);
  const bool exact = (long)(fmpz_bits(number) - fmpz_val2(number)) <= DBL_MANT_DIG;
  return (tp_near){value, exact ? 0 : fabs(value) * 2 * DBL_EPSILON};
}

/* top / bottom * 2^shift */
static tp_near near_of_ratio(const fmpz_t top, const fmpz_t bottom, long shift) {
  const long bits = (long)fmpz_bits(bottom);
  if (fmpz_is_zero(top)) return (tp_near){0, 0};
  return tp_near_div(near_of_whole(top, shift - bits), near_of_whole(bottom, -bits));
}

/* ---- the centroid ------------------------------------------------------------------------------
 */

void tp_centre_of_near(tp_centre *centre, const tp_surface *surface, const tp_near *sums) {
  *centre = (tp_centre){.surface = surface, .level = TP_LEVEL_DOUBLE, .volume6 = sums[TP_SOLID_V6]};
  fmpz_init(centre->weight4);
  const tp_near weight4 = tp_near_mul((tp_near){4, 0}, centre->volume6);
  for (int k = 0; k < 3; k++) {
    fmpz_init(centre->moment + k);
    centre->near[k] = tp_near_sign(weight4) != 0 ? tp_near_div(sums[TP_SOLID_X24 + k], weight4)
                                                 : (tp_near){0, INFINITY};
  }
}

void tp_centre_of_exact(tp_centre *centre, const tp_surface *surface, const fmpz *sums,
                        const fmpz_t multiple) {
  const long exponent = surface->exponent;
  *centre = (tp_centre){.surface = surface, .level = TP_LEVEL_EXACT};
  fmpz_init(centre->weight4);
  fmpz_mul_ui(centre->weight4, sums + TP_SOLID_V6, 4);
  centre->volume6 = near_of_ratio(sums + TP_SOLID_V6, multiple, -3 * exponent);
  for (int k = 0; k < 3; k++) {
    fmpz_init_set(centre->moment + k, sums + TP_SOLID_X24 + k);
    centre->near[k] = fmpz_is_zero(centre->weight4)
                          ? (tp_near){0, INFINITY}
                          : near_of_ratio(centre->moment + k, centre->weight4, -exponent);
  }
}

bool tp_centre_exactly(tp_centre *exact, const tp_centre *centre) {
  const tp_surface *summed = centre->summed;
  *exact = (tp_centre){.level = TP_LEVEL_DOUBLE};
  if (summed == NULL || summed->weights != NULL || centre->surface->weights != NULL) return false;
  fmpz sums[TP_SOLID_XX120];
  fmpz_t multiple;
  fmpz_init_set_ui(multiple, 1);
  for (int k = 0; k < TP_SOLID_XX120; k++) fmpz_init(sums + k);
  tp_solid_first_sums_exact(sums, summed);
  tp_centre_of_exact(exact, centre->surface, sums, multiple);
  for (int k = 0; k < TP_SOLID_XX120; k++) fmpz_clear(sums + k);
  fmpz_clear(multiple);
  return true;
}

void tp_centre_clear(tp_centre *centre) {
  fmpz_clear(centre->weight4);
  for (int k = 0; k < 3; k++) fmpz_clear(centre->moment + k);
}

/* ---- planes ------------------------------------------------------------------------------------
 */

static long most_bits(const fmpz v[3]) {
  long bits = 0;
  for (int k = 0; k < 3; k++) {
    const long own = (long)fmpz_bits(v + k);
    if (own > bits) bits = own;
  }
  return bits;
}

static void set_near(tp_rest_plane *plane) {
  const long bits = most_bits(plane->up);
  for (int k = 0; k < 3; k++) plane->near_up[k] = near_of_whole(plane->up + k, -bits);
}

void tp_rest_plane_across(tp_rest_plane *plane, const fmpz up[3], long vertex) {
  plane->vertex = vertex;
  for (int k = 0; k < 3; k++) fmpz_init_set(plane->up + k, up + k);
  set_near(plane);
}

static void cross(fmpz *product, const fmpz *a, const fmpz *b) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(product + k, a + i, b + j);
    fmpz_submul(product + k, a + j, b + i);
  }
}

static void dot(fmpz_t product, const fmpz *a, const fmpz *b) {
  fmpz_mul(product, a, b);
  fmpz_addmul(product, a + 1, b + 1);
  fmpz_addmul(product, a + 2, b + 2);
}

static void init_vector(fmpz *v) {
  for (int k = 0; k < 3; k++) fmpz_init(v + k);
}

static void clear_vector(fmpz *v) {
  for (int k = 0; k < 3; k++) fmpz_clear(v + k);
}

void tp_rest_plane_below(tp_rest_plane *plane, const tp_surface *surface, const int corners[3]) {
  fmpz one[3], other[3];
  init_vector(one);
  init_vector(other);
  init_vector(plane->up);
  tp_surface_way(one, surface, corners[0], corners[2]); /* counter-clockwise from below: outwards */
  tp_surface_way(other, surface, corners[0], corners[1]); /* is down */
  cross(plane->up, one, other);
  plane->vertex = corners[0];
  set_near(plane);
  clear_vector(one);
  clear_vector(other);
}

void tp_rest_plane_clear(tp_rest_plane *plane) {
  clear_vector(plane->up);
}

/* ---- doubles with bounds -----------------------------------------------------------------------
 */

static void near_side(tp_near side[3], const tp_surface *s, long from, long to) {
  for (int k = 0; k < 3; k++) {
    side[k] = tp_near_sub(tp_surface_near(s, to, k), tp_surface_near(s, from, k));
  }
}

static void near_cross(tp_near product[3], const tp_near a[3], const tp_near b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    product[k] = tp_near_sub(tp_near_mul(a[i], b[j]), tp_near_mul(a[j], b[i]));
  }
}

static tp_near near_dot(const tp_near a[3], const tp_near b[3]) {
  return tp_near_add(tp_near_add(tp_near_mul(a[0], b[0]), tp_near_mul(a[1], b[1])),
                     tp_near_mul(a[2], b[2]));
}

tp_near tp_near_norm(const tp_near v[3]) {
  return tp_near_sqrt(near_dot(v, v));
}

/* G - p */
static void near_from(tp_near from[3], const tp_centre *centre, long vertex) {
  for (int k = 0; k < 3; k++) {
    from[k] = tp_near_sub(centre->near[k], tp_surface_near(centre->surface, vertex, k));
  }
}

/* ---- whole numbers where these do not tell -----------------------------------------------------
 */

/* M - 4 V6 p, times the weight of p */
static void exact_from(fmpz *from, const tp_centre *centre, long vertex) {
  const fmpz *p = centre->surface->whole + 3 * vertex, *weights = centre->surface->weights;
  for (int k = 0; k < 3; k++) {
    if (weights == NULL) {
      fmpz_set(from + k, centre->moment + k);
    } else {
      fmpz_mul(from + k, centre->moment + k, weights + vertex);
    }
    fmpz_submul(from + k, centre->weight4, p + k);
  }
}

/* top / (4 V6 weight) * 2^shift */
static tp_near near_of_weighed(const fmpz_t top, const tp_centre *centre, const fmpz_t weight,
                               long shift) {
  fmpz_t bottom;
  fmpz_init(bottom);
  fmpz_mul(bottom, centre->weight4, weight);
  const tp_near told = near_of_ratio(top, bottom, shift);
  fmpz_clear(bottom);
  return told;
}

tp_near tp_centre_height(const tp_centre *centre, const tp_rest_plane *plane, double accuracy) {
  tp_near from[3];
  near_from(from, centre, plane->vertex);
  const tp_near near = near_dot(plane->near_up, from);
  if (tp_near_tells(near, accuracy) || centre->level != TP_LEVEL_EXACT) return near;
  const tp_surface *s = centre->surface;
  fmpz way[3], height, weight;
  init_vector(way);
  fmpz_init(&height);
  fmpz_init_set_ui(&weight, 1);
  if (s->weights != NULL) fmpz_set(&weight, s->weights + plane->vertex);
  exact_from(way, centre, plane->vertex);
  dot(&height, plane->up, way);
  const tp_near told =
      near_of_weighed(&height, centre, &weight, -s->exponent - most_bits(plane->up));
  clear_vector(way);
  fmpz_clear(&height);
  fmpz_clear(&weight);
  return told;
}

tp_near tp_centre_arm(const tp_centre *centre, const tp_rest_plane *plane, long from, long to,
                      double accuracy) {
  const tp_surface *s = centre->surface;
  tp_near side[3], way[3], turn[3];
  near_side(side, s, from, to);
  near_from(way, centre, from);
  near_cross(turn, side, way);
  const tp_near near = near_dot(plane->near_up, turn);
  if (tp_near_tells(near, accuracy) || centre->level != TP_LEVEL_EXACT) return near;
  fmpz edge[3], reach[3], product[3], arm, weight;
  init_vector(edge);
  init_vector(reach);
  init_vector(product);
  fmpz_init(&arm);
  fmpz_init(&weight);
  tp_surface_way(edge, s, from, to);
  exact_from(reach, centre, from);
  cross(product, edge, reach);
  dot(&arm, plane->up, product);
  tp_surface_weight(&weight, s, from, to);
  if (s->weights != NULL) fmpz_mul(&weight, &weight, s->weights + from);
  const tp_near told =
      near_of_weighed(&arm, centre, &weight, -2 * s->exponent - most_bits(plane->up));
  clear_vector(edge);
  clear_vector(reach);
  clear_vector(product);
  fmpz_clear(&arm);
  fmpz_clear(&weight);
  return told;
}

/* With n = up . (M - 4 V6 p) w, of the weight w of p: n^2 / (w |up|)^2 is the squared height times
 * a number that is the same for all planes: `top` over `bottom`. */
static void square_height(fmpz_t top, fmpz_t bottom, const tp_centre *centre,
                          const tp_rest_plane *plane) {
  const fmpz *weights = centre->surface->weights;
  fmpz way[3];
  init_vector(way);
  exact_from(way, centre, plane->vertex);
  dot(top, plane->up, way);
  fmpz_mul(top, top, top);
  dot(bottom, plane->up, plane->up);
  for (int k = 0; k < 2 && weights != NULL; k++) {
    fmpz_mul(bottom, bottom, weights + plane->vertex);
  }
  clear_vector(way);
}

int tp_centre_compare_heights(const tp_centre *centre, const tp_rest_plane *one,
                              const tp_rest_plane *other) {
  fmpz tops[2], bottoms[2];
  for (int k = 0; k < 2; k++) {
    fmpz_init(tops + k);
    fmpz_init(bottoms + k);
    square_height(tops + k, bottoms + k, centre, k == 0 ? one : other);
  }
  fmpz_mul(tops, tops, bottoms + 1);
  fmpz_mul(tops + 1, tops + 1, bottoms);
  const int order = fmpz_cmp(tops, tops + 1);
  for (int k = 0; k < 2; k++) {
    fmpz_clear(tops + k);
    fmpz_clear(bottoms + k);
  }
  return (order > 0) - (order < 0);
}

/* With e = (q - p) W and b = (M - 4 V6 p) w of weights, the foot is -up . (e x b) / (4 V6 w |e x
 * up|) beyond an edge: that squared, with its sign, times a number that is the same for all edges
 * of a plane. */
static void square_beyond(fmpz_t top, fmpz_t bottom, const tp_centre *centre,
                          const tp_rest_plane *plane, long from, long to) {
  const fmpz *weights = centre->surface->weights;
  fmpz edge[3], reach[3], product[3];
  init_vector(edge);
  init_vector(reach);
  init_vector(product);
  tp_surface_way(edge, centre->surface, from, to);
  exact_from(reach, centre, from);
  cross(product, edge, reach);
  dot(top, plane->up, product);
  const int sign = -fmpz_sgn(top);
  fmpz_mul(top, top, top);
  if (sign < 0) fmpz_neg(top, top);
  cross(product, edge, plane->up);
  dot(bottom, product, product);
  for (int k = 0; k < 2 && weights != NULL; k++) fmpz_mul(bottom, bottom, weights + from);
  clear_vector(edge);
  clear_vector(reach);
  clear_vector(product);
}

int tp_centre_compare_beyond(const tp_centre *centre, const tp_rest_plane *plane,
                             const long from[2], const long to[2]) {
  fmpz tops[2], bottoms[2];
  for (int k = 0; k < 2; k++) {
    fmpz_init(tops + k);
    fmpz_init(bottoms + k);
    square_beyond(tops + k, bottoms + k, centre, plane, from[k], to[k]);
  }
  fmpz_mul(tops, tops, bottoms + 1);
  fmpz_mul(tops + 1, tops + 1, bottoms);
  const int order = fmpz_cmp(tops, tops + 1);
  for (int k = 0; k < 2; k++) {
    fmpz_clear(tops + k);
    fmpz_clear(bottoms + k);
  }
  return (order > 0) - (order < 0);
}

void tp_rest_plane_outward(tp_near outward[3], const tp_surface *surface,
                           const tp_rest_plane *plane, long from, long to) {
  static const double accuracy = 1e-14;
  if (surface->is_exact) {
    tp_near side[3];
    near_side(side, surface, from, to);
    near_cross(outward, side, plane->near_up);
    if (tp_near_tells(tp_near_norm(outward), accuracy)) return;
  }
  /* zeros of rounded coordinates are none, and arms of a hair's breadth make much of them */
  fmpz edge[3], across[3], weight;
  init_vector(edge);
  init_vector(across);
  fmpz_init(&weight);
  tp_surface_way(edge, surface, from, to);
  tp_surface_weight(&weight, surface, from, to);
  cross(across, edge, plane->up);
  for (int k = 0; k < 3; k++) {
    outward[k] = near_of_ratio(across + k, &weight, -surface->exponent - most_bits(plane->up));
  }
  fmpz_clear(&weight);
  clear_vector(edge);
  clear_vector(across);
}
