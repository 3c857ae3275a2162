/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact coordinates by whole numbers: origin + m unit. Where both have one denominator of one word,
 * as decimals do, a coordinate takes a few operations on words; else it is made by rationals. */

#ifndef TP_GENERATE_TICKS_H
#define TP_GENERATE_TICKS_H

#include <flint/fmpq.h>
#include <stdint.h>

typedef struct tp_ticks {
  fmpq_t origin, unit;
  int64_t first, each, below; /* (first + m each) / below; below 0: not of one word */
  int twos;                   /* below = 2^twos 5^k other */
  int64_t other;
  int64_t most; /* for |m| up to here first + m each is a word */
} tp_ticks;

void tp_ticks_init(tp_ticks *ticks, const fmpq_t origin, const fmpq_t unit);
void tp_ticks_clear(tp_ticks *ticks);

/* `value` is a number already. */
void tp_ticks_at(fmpq_t value, const tp_ticks *ticks, int64_t m);

/* The greatest power of ten that is at most a millionth of `size`, which is above zero. */
void tp_ticks_millionth(fmpq_t unit, const fmpq_t size);

/* The multiple of `unit` nearest to `value`, of two the greater. */
void tp_ticks_round(fmpq_t value, const fmpq_t unit);

#endif
