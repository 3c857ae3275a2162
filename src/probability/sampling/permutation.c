/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Eight double rounds of a Feistel network with cycle walking. */

#include "sampling/permutation.h"

#include "generate/random.h"

enum { ROUNDS = 8 };

tp_permutation tp_permutation_of(uint64_t count, uint64_t key) {
  unsigned bits = 0;
  while (UINT64_C(1) << bits < count) bits++;
  return (tp_permutation){
      .count = count, .key = key, .low_bits = bits / 2, .high_bits = bits - bits / 2};
}

/* Both halves changed by one mixing each. */
static uint64_t turn(const tp_permutation *p, uint64_t value) {
  const uint64_t low_mask = (UINT64_C(1) << p->low_bits) - 1;
  const uint64_t high_mask = (UINT64_C(1) << p->high_bits) - 1;
  uint64_t low = value & low_mask, high = value >> p->low_bits;
  for (uint64_t round = 0; round < ROUNDS; round++) {
    high ^= tp_random_bits(p->key + low, 2 * round) & high_mask;
    low ^= tp_random_bits(p->key + high, 2 * round + 1) & low_mask;
  }
  return high << p->low_bits | low;
}

uint64_t tp_permutation_at(const tp_permutation *permutation, uint64_t k) {
  uint64_t value = k;
  do value = turn(permutation, value);
  while (value >= permutation->count);
  return value;
}
