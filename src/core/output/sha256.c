/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names as in FIPS 180-4, section 6.2. The constants are the first 32 bits of the fractional parts
 * of the square roots of the first 8 primes, and of the cube roots of the first 64. */

#include "output/sha256.h"

#include <stdbool.h>
#include <string.h>

enum { BLOCK = 64, ROUNDS = 64 };

static const uint32_t round_constants[ROUNDS] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

static uint32_t turned(uint32_t word, int bits) {
  return word >> bits | word << (32 - bits);
}

static void expand(uint32_t w[ROUNDS], const uint8_t *block) {
  for (int t = 0; t < 16; t++) {
    w[t] = (uint32_t)block[4 * t] << 24 | (uint32_t)block[4 * t + 1] << 16 |
           (uint32_t)block[4 * t + 2] << 8 | block[4 * t + 3];
  }
  for (int t = 16; t < ROUNDS; t++) {
    const uint32_t a = w[t - 15], b = w[t - 2];
    w[t] = w[t - 16] + (turned(a, 7) ^ turned(a, 18) ^ a >> 3) + w[t - 7] +
           (turned(b, 17) ^ turned(b, 19) ^ b >> 10);
  }
}

static void add_block(uint32_t h[8], const uint8_t *block) {
  uint32_t w[ROUNDS], v[8];
  expand(w, block);
  memcpy(v, h, sizeof v);
  for (int t = 0; t < ROUNDS; t++) {
    const uint32_t a = v[0], e = v[4];
    const uint32_t one = v[7] + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) +
                         ((e & v[5]) ^ (~e & v[6])) + round_constants[t] + w[t];
    const uint32_t two =
        (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]));
    memmove(v + 1, v, 7 * sizeof v[0]);
    v[4] += one;
    v[0] = one + two;
  }
  for (int k = 0; k < 8; k++) h[k] += v[k];
}

void tp_sha256_begin(tp_sha256_state *state) {
  *state = (tp_sha256_state){.h = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f,
                                   0x9b05688c, 0x1f83d9ab, 0x5be0cd19}};
}

void tp_sha256_add(tp_sha256_state *state, const void *bytes, size_t length) {
  const uint8_t *at = bytes;
  size_t kept = state->length % BLOCK, left = length;
  state->length += length;
  while (left > 0) {
    const bool direct = kept == 0 && left >= BLOCK;
    const size_t taken = left < BLOCK - kept ? left : BLOCK - kept;
    if (!direct) memcpy(state->rest + kept, at, taken);
    kept = (kept + taken) % BLOCK;
    if (kept == 0) add_block(state->h, direct ? at : state->rest);
    at += taken;
    left -= taken;
  }
}

void tp_sha256_tell(uint8_t hash[TP_SHA256_SIZE], const tp_sha256_state *state) {
  uint32_t h[8];
  uint8_t last[2 * BLOCK] = {0};
  const size_t left = state->length % BLOCK;
  memcpy(h, state->h, sizeof h);
  /* what is left, a bit, and the number of bits in the last 8 bytes */
  const size_t blocks = left < BLOCK - 8 ? 1 : 2;
  memcpy(last, state->rest, left);
  last[left] = 0x80;
  const uint64_t bits = state->length * 8;
  for (size_t k = 0; k < 8; k++) last[blocks * BLOCK - 1 - k] = (uint8_t)(bits >> 8 * k);
  for (size_t k = 0; k < blocks; k++) add_block(h, last + k * BLOCK);
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) {
    hash[k] = (uint8_t)(h[k / 4] >> (24 - 8 * (k % 4)));
  }
}

void tp_sha256(uint8_t hash[TP_SHA256_SIZE], const void *bytes, size_t length) {
  tp_sha256_state state;
  tp_sha256_begin(&state);
  tp_sha256_add(&state, bytes, length);
  tp_sha256_tell(hash, &state);
}

void tp_sha256_text(char text[TP_SHA256_TEXT], const uint8_t hash[TP_SHA256_SIZE]) {
  static const char digits[] = "0123456789abcdef";
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) {
    text[2 * k] = digits[hash[k] >> 4];
    text[2 * k + 1] = digits[hash[k] & 15];
  }
  text[TP_SHA256_TEXT - 1] = '\0';
}
