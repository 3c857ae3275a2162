/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact signs of vertices whose coordinates fit into words, which those of most files do: for a
 * twentieth of what whole numbers of any size take. */

#ifndef TP_SOLID_WORD_TURNS_H
#define TP_SOLID_WORD_TURNS_H

#include "number/word.h"
#include "solid/surface.h"

/* Of the components of vectors below; of coordinates, so that 64 times the difference of two,
 * and the sum of three such vectors, are within. */
enum { TP_TURN_WORD_BITS = 61, TP_SURFACE_WORD_BITS = 52 };

/* Are coordinates below 2^TP_SURFACE_WORD_BITS, without weights? */
static inline bool tp_surface_has_words(const tp_surface *surface) {
  return surface->weights == NULL && surface->exponent <= TP_SURFACE_WORD_BITS;
}

static inline void tp_surface_word_way(int64_t way[3], const tp_surface *surface, long from,
                                       long to) {
  const fmpz *one = surface->whole + 3 * from, *other = surface->whole + 3 * to;
  for (int k = 0; k < 3; k++) way[k] = tp_word_get(other + k) - tp_word_get(one + k);
}

/* The component k of a x b, of less than 124 bits. */
static inline __int128 tp_word_cross(const int64_t a[3], const int64_t b[3], int k) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  return (__int128)a[i] * b[j] - (__int128)a[j] * b[i];
}

/* The sign of (a x b) . c. A component is 2^64 times a word, plus a word without a sign: their
 * products with c are below 2^121 and 2^125. */
static inline int tp_word_turn(const int64_t a[3], const int64_t b[3], const int64_t c[3]) {
  __int128 high = 0, low = 0;
  for (int k = 0; k < 3; k++) {
    const __int128 turn = tp_word_cross(a, b, k);
    high += (turn >> 64) * c[k];
    low += (__int128)(uint64_t)turn * c[k];
  }
  high += low >> 64;
  if (high != 0) return high > 0 ? 1 : -1;
  return (uint64_t)low != 0;
}

#endif
