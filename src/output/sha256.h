/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The secure hash SHA-256 (FIPS 180-4) of bytes, by which a page names the input that it is of:
 * anyone can make the same with sha256sum. */

#ifndef TP_SHA256_H
#define TP_SHA256_H

#include <stddef.h>
#include <stdint.h>

enum { TP_SHA256_SIZE = 32 };

void tp_sha256(uint8_t hash[TP_SHA256_SIZE], const void *bytes, size_t length);

#endif
