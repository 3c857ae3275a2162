/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is an outline a simple polygon: its edges meet in the vertex that two of them share, and nowhere
 * else? */

#ifndef TP_BATCH_SIMPLE_H
#define TP_BATCH_SIMPLE_H

#include <stdbool.h>

enum { TP_SIMPLE_MOST = 1024 };

/* Does double arithmetic prove it? `count` vertices, and the first one once more. False as well
 * where there are more than TP_SIMPLE_MOST, and where a sign is within the error of its sum. */
bool tp_is_simple(const double *x, const double *y, long count);

#endif
