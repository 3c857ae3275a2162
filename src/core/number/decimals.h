/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Decimal texts of balls, to more digits than a double holds, and what owns them. Both ends of a
 * ball are rounded to nearest by MPFR, and the text has the most digits on which the two agree: all
 * of them are certain. */

#ifndef TP_NUMBER_DECIMALS_H
#define TP_NUMBER_DECIMALS_H

#include <arb.h>
#include <stdbool.h>

typedef struct tp_decimals tp_decimals;

/* Doubles hold this many digits; texts are kept where more are asked for. */
enum { TP_DECIMALS_OF_DOUBLE = 15 };

/* NULL when memory is exhausted. */
tp_decimals *tp_decimals_new(int digits);
void tp_decimals_free(tp_decimals *decimals);

/* The text of a ball: `digits` significant ones, fewer where they do not round alike over all of
 * the ball, and no zeros at the end of an exact decimal. NULL where not even one does, or memory is
 * exhausted, which tp_decimals_failed then tells. The text lives as long as `decimals`. */
const char *tp_decimals_keep(tp_decimals *decimals, const arb_t ball);
bool tp_decimals_failed(const tp_decimals *decimals);

#endif
