/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A double as the shortest decimal that names it, and that decimal as it is. */

#ifndef TP_SHORTEST_H
#define TP_SHORTEST_H

#include "topple_basics.h"

#include <flint/fmpq.h>

enum { TP_SHORTEST_SIZE = 32 };

/* The shortest of the decimals of 15 to 17 digits that name the double, which is finite. */
const char *tp_shortest(char out[TP_SHORTEST_SIZE], double value);

/* The number that this decimal is; false: outside of the range that a scene takes, or not finite.
 */
TP_MUST_USE bool tp_shortest_exact(fmpq_t number, double value);

#endif
