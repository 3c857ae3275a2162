/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of primitive polynomials and first direction numbers (Algorithm 659), the recurrence for
 * the others, and points by Gray's code. */

#include "sampling/sobol_points.h"

/* x^degree + ... + 1, its inner coefficients as bits from the highest power on, and the odd numbers
 * that the recurrence begins with. Of the first dimension, which has no polynomial, all are 1. */
typedef struct generator {
  uint8_t degree, inner, first[8];
} generator;

static const generator generators[TP_SOBOL_DIMENSIONS - 1] = {
    {1, 0, {1}},
    {2, 1, {1, 1}},
    {3, 1, {1, 3, 7}},
    {3, 2, {1, 1, 5}},
    {4, 1, {1, 3, 1, 1}},
    {4, 4, {1, 1, 3, 7}},
    {5, 2, {1, 3, 3, 9, 9}},
    {5, 13, {1, 3, 7, 13, 3}},
    {5, 7, {1, 1, 5, 11, 27}},
    {5, 14, {1, 3, 5, 1, 15}},
    {5, 11, {1, 1, 7, 3, 29}},
    {5, 4, {1, 3, 7, 7, 21}},
    {6, 1, {1, 1, 1, 9, 23, 37}},
    {6, 16, {1, 3, 3, 5, 19, 33}},
    {6, 13, {1, 1, 3, 13, 11, 7}},
    {6, 22, {1, 1, 7, 13, 25, 5}},
    {6, 19, {1, 3, 5, 11, 7, 11}},
    {6, 25, {1, 1, 1, 3, 13, 39}},
    {7, 1, {1, 3, 1, 15, 17, 63, 13}},
    {7, 32, {1, 1, 5, 5, 1, 27, 33}},
    {7, 4, {1, 3, 3, 3, 25, 17, 115}},
    {7, 8, {1, 1, 3, 15, 29, 15, 41}},
    {7, 7, {1, 3, 1, 7, 3, 23, 79}},
    {7, 56, {1, 3, 7, 9, 31, 29, 17}},
    {7, 14, {1, 1, 5, 13, 11, 3, 29}},
    {7, 28, {1, 3, 1, 9, 5, 21, 119}},
    {7, 19, {1, 1, 3, 1, 23, 13, 75}},
    {7, 50, {1, 3, 3, 11, 27, 31, 73}},
    {7, 21, {1, 1, 7, 7, 19, 25, 105}},
    {7, 42, {1, 3, 5, 5, 21, 9, 7}},
    {7, 31, {1, 1, 1, 15, 5, 49, 59}},
    {7, 62, {1, 1, 1, 1, 1, 33, 65}},
    {7, 37, {1, 3, 5, 15, 17, 19, 21}},
    {7, 41, {1, 1, 7, 11, 13, 29, 3}},
    {7, 55, {1, 3, 7, 5, 7, 11, 113}},
    {7, 59, {1, 1, 5, 3, 15, 19, 61}},
    {8, 14, {1, 3, 1, 1, 9, 27, 89, 7}},
    {8, 56, {1, 1, 3, 7, 31, 15, 45, 23}},
    {8, 21, {1, 3, 3, 9, 9, 25, 107, 39}},
};

/* m_i = 2 a_1 m_(i-1) ^ 4 a_2 m_(i-2) ^ ... ^ 2^s m_(i-s) ^ m_(i-s), of those before its place. */
static uint64_t next_of(const generator *g, const uint64_t *numbers, unsigned i) {
  uint64_t next = numbers[i - g->degree] ^ numbers[i - g->degree] << g->degree;
  for (unsigned before = i - g->degree + 1; before < i; before++) {
    const unsigned k = i - before;
    if (g->inner >> (g->degree - 1U - k) & 1U) next ^= numbers[before] << k;
  }
  return next;
}

/* Each of them by its place: the direction is m_i / 2^(i + 1). */
void tp_sobol_directions(uint64_t directions[TP_SOBOL_BITS], size_t dimension) {
  uint64_t numbers[TP_SOBOL_BITS] = {0};
  const generator *g = dimension > 0 ? generators + dimension - 1 : NULL;
  for (unsigned i = 0; i < TP_SOBOL_BITS; i++) {
    numbers[i] = g == NULL ? 1 : i < g->degree ? g->first[i] : next_of(g, numbers, i);
    directions[i] = numbers[i] << (TP_SOBOL_BITS - 1U - i);
  }
}

/* The directions of the bits of Gray's code of the point. */
uint64_t tp_sobol_coordinate(const uint64_t directions[TP_SOBOL_BITS], uint64_t point) {
  uint64_t coordinate = 0;
  const uint64_t gray = point ^ point >> 1;
  for (unsigned i = 0; i < TP_SOBOL_BITS; i++) {
    if (gray >> i & 1U) coordinate ^= directions[i];
  }
  return coordinate;
}

unsigned tp_sobol_step(uint64_t point) {
  unsigned bit = 0;
  while (point >> bit & 1U) bit++;
  return bit;
}
