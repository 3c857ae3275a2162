/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random numbers by a counter: number k of a stream is a function of the seed, the stream and k
 * alone, by whole numbers of 64 bits, hence the same on every machine and in any order. SplitMix64
 * (Steele, Lea, Flood, OOPSLA 2014): the state goes on by an odd constant, and two rounds of
 * multiplications mix it. */

#ifndef TP_GENERATE_RANDOM_H
#define TP_GENERATE_RANDOM_H

#include <stdint.h>

/* What the numbers are for: of generated profiles, of sampling/, of statistics/ and of joints. */
typedef enum tp_stream {
  TP_STREAM_TEETH = 1,
  TP_STREAM_WAVES,
  TP_STREAM_NOISE,
  TP_STREAM_SAMPLES,
  TP_STREAM_STRATA,
  TP_STREAM_SHIFTS,
  TP_STREAM_BOOTSTRAP,
  TP_STREAM_IMPORTANCE,
  TP_STREAM_SUBSETS,
  TP_STREAM_DIRECTIONS,
  TP_STREAM_JOINTS
} tp_stream;

static inline uint64_t tp_random_mix(uint64_t state) {
  state = (state ^ (state >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  state = (state ^ (state >> 27)) * UINT64_C(0x94d049bb133111eb);
  return state ^ (state >> 31);
}

/* Where a stream of a seed begins. */
static inline uint64_t tp_random_stream(uint64_t seed, tp_stream stream) {
  return tp_random_mix(tp_random_mix(seed + UINT64_C(0x9e3779b97f4a7c15)) + (uint64_t)stream);
}

static inline uint64_t tp_random_bits(uint64_t stream, uint64_t k) {
  return tp_random_mix(stream + (k + 1) * UINT64_C(0x9e3779b97f4a7c15));
}

/* Stream number k of those that a stream falls into. */
static inline uint64_t tp_random_branch(uint64_t stream, uint64_t k) {
  return tp_random_mix(stream ^ tp_random_mix(k + UINT64_C(0xd1b54a32d192ed03)));
}

/* Evenly within (0, 1), of 52 bits: an odd multiple of 2^-53. */
static inline double tp_random_unit(uint64_t bits) {
  return ((double)(bits >> 12) + 0.5) * 0x1p-52;
}

/* Evenly within (-1, 1), of 32 bits: an odd multiple of 2^-32. */
static inline double tp_random_even(uint32_t bits) {
  return ((double)bits * 2 + 1 - 0x1p32) * 0x1p-32;
}

#endif
