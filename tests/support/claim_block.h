/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the tests of random blocks and outlines share: a claim names the seed of what is in hand. */

#ifndef TP_TEST_CLAIM_BLOCK_H
#define TP_TEST_CLAIM_BLOCK_H

#include "random_blocks.h"

#include "topple.h"

#include <stdint.h>

extern uint64_t seed; /* of the block in hand */
extern tp_message claim_message;

void claim(bool condition, const char *what);

/* Whole numbers, exactly. */
typedef __int128 wide;

/* (b - a) . (d - c) of four vertices. */
wide dot(const polygon *p, long a, long b, long c, long d);

#endif
