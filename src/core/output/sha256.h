/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The secure hash SHA-256 (FIPS 180-4) of bytes, by which a page names the input that it is of:
 * anyone can make the same with sha256sum. */

#ifndef TP_OUTPUT_SHA256_H
#define TP_OUTPUT_SHA256_H

#include <stddef.h>
#include <stdint.h>

enum { TP_SHA256_SIZE = 32 };

void tp_sha256(uint8_t hash[TP_SHA256_SIZE], const void *bytes, size_t length);

/* The same of bytes that come in pieces: begun, added to, and told of all so far, after which more
 * may follow. */
typedef struct tp_sha256_state {
  uint32_t h[8];
  uint8_t rest[64]; /* bytes that make no block yet */
  uint64_t length;
} tp_sha256_state;

void tp_sha256_begin(tp_sha256_state *state);
void tp_sha256_add(tp_sha256_state *state, const void *bytes, size_t length);
void tp_sha256_tell(uint8_t hash[TP_SHA256_SIZE], const tp_sha256_state *state);

/* In hexadecimal, as sha256sum prints it. */
enum { TP_SHA256_TEXT = 2 * TP_SHA256_SIZE + 1 };
void tp_sha256_text(char text[TP_SHA256_TEXT], const uint8_t hash[TP_SHA256_SIZE]);

#endif
