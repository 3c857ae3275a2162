/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundary sums exactly and in balls, from the one definition in ring_sums_in.h. */

#include "block/ring_sums.h"

const tp_degree tp_sum_degree[TP_SUM_COUNT] = {{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 3}, {2, 2}};

#define NUMBER fmpz
#define COORDINATE fmpz
#define PARAMETER
#define FUNCTION exact_sums
#define INIT fmpz_init
#define CLEAR fmpz_clear
#define ZERO fmpz_zero
#define SET_COORDINATE fmpz_set
#define ADD fmpz_add
#define SUBTRACT fmpz_sub
#define MULTIPLY fmpz_mul
#define ADD_PRODUCT fmpz_addmul
#include "block/ring_sums_in.h"

#define NUMBER arb_struct
#define COORDINATE fmpz
#define PARAMETER , long bits
#define FUNCTION ball_sums
#define INIT arb_init
#define CLEAR arb_clear
#define ZERO arb_zero
#define SET_COORDINATE(r, n) arb_set_round_fmpz(r, n, bits)
#define ADD(r, a, b) arb_add(r, a, b, bits)
#define SUBTRACT(r, a, b) arb_sub(r, a, b, bits)
#define MULTIPLY(r, a, b) arb_mul(r, a, b, bits)
#define ADD_PRODUCT(r, a, b) arb_addmul(r, a, b, bits)
#include "block/ring_sums_in.h"

void tp_ring_sums_exact_first(fmpz *sums, const fmpz *x, const fmpz *y, long count, int sum_count) {
  exact_sums(sums, x, y, count, sum_count);
}

void tp_ring_sums_exact(fmpz sums[TP_SUM_COUNT], const fmpz *x, const fmpz *y, long count) {
  exact_sums(sums, x, y, count, TP_SUM_COUNT);
}

void tp_ring_sums_ball_first(arb_struct *sums, const fmpz *x, const fmpz *y, long count, long bits,
                             int sum_count) {
  ball_sums(sums, x, y, count, sum_count, bits);
}

void tp_ring_sums_ball(arb_struct sums[TP_SUM_COUNT], const fmpz *x, const fmpz *y, long count,
                       long bits) {
  ball_sums(sums, x, y, count, TP_SUM_COUNT, bits);
}
