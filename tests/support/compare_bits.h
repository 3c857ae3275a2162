/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Are two solutions the same bits, but for a power of two in all lengths? */

#ifndef TP_TEST_COMPARE_BITS_H
#define TP_TEST_COMPARE_BITS_H

#include "topple.h"

/* Angles, factors and decisions are equal, lengths and bounds of lengths 2^power times as large,
 * and so on. The scene gives no friction: which of two equal bases the search for a limit ends in
 * may depend on the rounded logarithm of a length. False, with the first difference in `why`. */
bool solutions_same_bits(char why[256], const tp_solution *one, const tp_solution *other,
                         int power);

#endif
