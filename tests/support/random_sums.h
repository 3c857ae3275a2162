/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moment sums of a polygon by a fan of triangles, in integers of 128 bits: a route that shares
 * nothing with the library's. With coordinates up to 2^27 and 1024 vertices the terms stay below
 * 2 (2^28)^2 6 (2^27)^2 = 2^114, and their sum below 2^124. */

#ifndef TP_TEST_RANDOM_SUMS_H
#define TP_TEST_RANDOM_SUMS_H

#include "block/ring_sums.h"
#include "random_polygons.h"

typedef __int128 wide;
typedef struct sums {
  wide of[TP_SUM_COUNT];
} sums;

sums polygon_sums(const polygon *p);

/* Few vertices mostly; sometimes past the seams of the double sums at 8 and 512. No coordinate is
 * beyond 2^21. */
void draw_polygon(polygon *p, random_numbers *state);

void fmpz_set_wide(fmpz_t integer, wide value);

#endif
