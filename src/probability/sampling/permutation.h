/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A random permutation of 0 ... count - 1, entry by entry and without memory: a Feistel network on
 * the least power of two that holds them, whose results beyond `count` are put in again until one
 * is within (cycle walking; Black and Rogaway, CT-RSA 2002). Each round changes one half by a
 * function of the other, so it is a permutation whatever the functions are: here the mixing of
 * generate/random.h. Fewer than two turns at the mean, of eight double rounds each. */

#ifndef TP_SAMPLING_PERMUTATION_H
#define TP_SAMPLING_PERMUTATION_H

#include <stdint.h>

typedef struct tp_permutation {
  uint64_t count, key;
  unsigned low_bits, high_bits;
} tp_permutation;

/* `count` is at least 1 and at most 2^62. */
tp_permutation tp_permutation_of(uint64_t count, uint64_t key);

uint64_t tp_permutation_at(const tp_permutation *permutation, uint64_t k);

#endif
