/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signs of determinants of coordinate differences: by words where coordinates fit into them, else
 * by doubles with bounds before whole numbers. */

#include "solid/turns.h"

#include "solid/word_turns.h"

/* (b - a) x (c - a) */
static void near_turn(tp_near turn[3], const tp_surface *surface, int a, int b, int c) {
  tp_near one[3], other[3];
  for (int k = 0; k < 3; k++) {
    const tp_near own = tp_surface_near(surface, a, k);
    one[k] = tp_near_sub(tp_surface_near(surface, b, k), own);
    other[k] = tp_near_sub(tp_surface_near(surface, c, k), own);
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    turn[k] = tp_near_sub(tp_near_mul(one[i], other[j]), tp_near_mul(one[j], other[i]));
  }
}

/* Times a number above 0, of weights; `turn` is initialised. */
static void exact_turn(fmpz *turn, const tp_surface *surface, int a, int b, int c) {
  fmpz sides[6];
  for (int k = 0; k < 6; k++) fmpz_init(sides + k);
  tp_surface_way(sides, surface, a, b);
  tp_surface_way(sides + 3, surface, a, c);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(turn + k, sides + i, sides + 3 + j);
    fmpz_submul(turn + k, sides + j, sides + 3 + i);
  }
  for (int k = 0; k < 6; k++) fmpz_clear(sides + k);
}

bool tp_surface_is_straight(const tp_surface *surface, int a, int b, int c) {
  if (tp_surface_has_words(surface)) {
    int64_t one[3], other[3];
    tp_surface_word_way(one, surface, a, b);
    tp_surface_word_way(other, surface, a, c);
    return tp_word_cross(one, other, 0) == 0 && tp_word_cross(one, other, 1) == 0 &&
           tp_word_cross(one, other, 2) == 0;
  }
  tp_near near[3];
  near_turn(near, surface, a, b, c);
  for (int k = 0; k < 3; k++) {
    if (tp_near_sign(near[k]) != 0) return false;
  }
  fmpz turn[3];
  for (int k = 0; k < 3; k++) fmpz_init(turn + k);
  exact_turn(turn, surface, a, b, c);
  const bool straight = fmpz_is_zero(turn) && fmpz_is_zero(turn + 1) && fmpz_is_zero(turn + 2);
  for (int k = 0; k < 3; k++) fmpz_clear(turn + k);
  return straight;
}

int tp_surface_side(const tp_surface *surface, const int corners[3], int vertex) {
  if (tp_surface_has_words(surface)) {
    int64_t ways[3][3];
    tp_surface_word_way(ways[0], surface, corners[0], corners[1]);
    tp_surface_word_way(ways[1], surface, corners[0], corners[2]);
    tp_surface_word_way(ways[2], surface, corners[0], vertex);
    return tp_word_turn(ways[0], ways[1], ways[2]);
  }
  tp_near near[3], sum = {0, 0};
  near_turn(near, surface, corners[0], corners[1], corners[2]);
  for (int k = 0; k < 3; k++) {
    const tp_near way =
        tp_near_sub(tp_surface_near(surface, vertex, k), tp_surface_near(surface, corners[0], k));
    sum = tp_near_add(sum, tp_near_mul(near[k], way));
  }
  if (tp_near_sign(sum) != 0) return tp_near_sign(sum);
  fmpz turn[3], way[3], total;
  for (int k = 0; k < 3; k++) {
    fmpz_init(turn + k);
    fmpz_init(way + k);
  }
  fmpz_init(&total);
  exact_turn(turn, surface, corners[0], corners[1], corners[2]);
  tp_surface_way(way, surface, corners[0], vertex);
  for (int k = 0; k < 3; k++) fmpz_addmul(&total, turn + k, way + k);
  const int side = fmpz_sgn(&total);
  for (int k = 0; k < 3; k++) {
    fmpz_clear(turn + k);
    fmpz_clear(way + k);
  }
  fmpz_clear(&total);
  return side;
}
