/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Six times the volume of a tetrahedron, d = a . (b x c), is below 2^167, and its product with a
 * sum of three coordinates below 2^223. Each is added as a number of three words. */

#include "solid/word_heights.h"

/* ---- sums --------------------------------------------------------------------------------------
 */

/* high 2^128 + middle 2^64 + low */
typedef struct word_sum {
  __int128 high;
  uint64_t middle, low;
} word_sum;

/* The number times a factor below 2^56. The high word of d is below 2^40: TP_MESH_MOST times the
 * product of both is below 2^121. */
static void add_times(word_sum *sum, const word_sum *number, int64_t factor) {
  const __int128 low = (__int128)number->low * factor + sum->low;
  const __int128 middle = (__int128)number->middle * factor + sum->middle + (low >> 64);
  sum->low = (uint64_t)low;
  sum->middle = (uint64_t)middle;
  sum->high += number->high * factor + (middle >> 64);
}

static void take_corner(int64_t at[3], const tp_surface *surface, long vertex) {
  for (int k = 0; k < 3; k++) at[k] = tp_word_get(surface->whole + 3 * vertex + k);
}

/* To six times the volume, and to 24 times the integrals of x, y, z (solid/solid_sums.h). */
static void add_triangle(word_sum sums[4], const tp_surface *surface, const int *corners) {
  int64_t at[3][3], one[3], other[3];
  for (int c = 0; c < 3; c++) take_corner(at[c], surface, corners[c]);
  for (int k = 0; k < 3; k++) {
    one[k] = at[1][k] - at[0][k];
    other[k] = at[2][k] - at[0][k];
  }
  word_sum volume = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    const __int128 turn = tp_word_cross(one, other, k);
    const __int128 high = turn >> 64;
    const word_sum area = {high >> 64, (uint64_t)high, (uint64_t)turn};
    add_times(&volume, &area, at[0][k]);
  }
  add_times(sums, &volume, 1);
  for (int k = 0; k < 3; k++) {
    add_times(sums + 1 + k, &volume, at[0][k] + at[1][k] + at[2][k]);
  }
}

/* ---- numbers of GMP ----------------------------------------------------------------------------
 */

static void set_wide(mpz_t number, __int128 wide) {
  const unsigned __int128 size = wide < 0 ? -(unsigned __int128)wide : (unsigned __int128)wide;
  const uint64_t words[2] = {(uint64_t)size, (uint64_t)(size >> 64)};
  mpz_import(number, 2, -1, sizeof *words, 0, 0, words);
  if (wide < 0) mpz_neg(number, number);
}

static void set_sum(mpz_t number, const word_sum *sum) {
  const uint64_t words[2] = {sum->low, sum->middle};
  mpz_t rest;
  mpz_init(rest);
  mpz_import(rest, 2, -1, sizeof *words, 0, 0, words);
  set_wide(number, sum->high);
  mpz_mul_2exp(number, number, 128);
  mpz_add(number, number, rest);
  mpz_clear(rest);
}

void tp_word_centre_init(tp_word_centre *centre, const tp_surface *surface) {
  word_sum sums[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (long t = 0; t < surface->triangle_count; t++) {
    add_triangle(sums, surface, surface->triangles + 3 * t);
  }
  mpz_init(centre->weight4);
  set_sum(centre->weight4, sums);
  mpz_mul_2exp(centre->weight4, centre->weight4, 2);
  for (int k = 0; k < 3; k++) {
    mpz_init(centre->moment[k]);
    set_sum(centre->moment[k], sums + 1 + k);
  }
}

void tp_word_centre_clear(tp_word_centre *centre) {
  mpz_clear(centre->weight4);
  for (int k = 0; k < 3; k++) mpz_clear(centre->moment[k]);
}

/* With u across the plane of vertices and p one of them: (u . (M - 4 V6 p))^2 and u . u, whose
 * quotient is the squared height times a number that is the same for all planes. */
static void square_height(mpz_t top, mpz_t bottom, const tp_word_centre *centre,
                          const tp_surface *surface, const int corners[3]) {
  int64_t one[3], other[3], at[3];
  mpz_t up, way;
  mpz_init(up);
  mpz_init(way);
  take_corner(at, surface, corners[0]);
  tp_surface_word_way(one, surface, corners[0], corners[1]);
  tp_surface_word_way(other, surface, corners[0], corners[2]);
  mpz_set_ui(top, 0);
  mpz_set_ui(bottom, 0);
  for (int k = 0; k < 3; k++) {
    set_wide(up, tp_word_cross(one, other, k));
    mpz_addmul(bottom, up, up);
    set_wide(way, at[k]);
    mpz_mul(way, way, centre->weight4);
    mpz_sub(way, centre->moment[k], way);
    mpz_addmul(top, up, way);
  }
  mpz_mul(top, top, top);
  mpz_clear(up);
  mpz_clear(way);
}

int tp_word_centre_compare(const tp_word_centre *centre, const tp_surface *surface,
                           const int one[3], const int other[3]) {
  mpz_t tops[2], bottoms[2];
  for (int k = 0; k < 2; k++) {
    mpz_init(tops[k]);
    mpz_init(bottoms[k]);
    square_height(tops[k], bottoms[k], centre, surface, k == 0 ? one : other);
  }
  mpz_mul(tops[0], tops[0], bottoms[1]);
  mpz_mul(tops[1], tops[1], bottoms[0]);
  const int order = mpz_cmp(tops[0], tops[1]);
  for (int k = 0; k < 2; k++) {
    mpz_clear(tops[k]);
    mpz_clear(bottoms[k]);
  }
  return (order > 0) - (order < 0);
}
