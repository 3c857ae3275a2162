/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A text that grows, and numbers in it of which every printed digit is certain. */

#ifndef TP_OUTPUT_TEXT_H
#define TP_OUTPUT_TEXT_H

#include "topple.h"

#include <stdarg.h>

typedef struct tp_text {
  char *data; /* NULL until something is added */
  size_t length, capacity;
  bool failed; /* memory was exhausted; the rest is dropped */
} tp_text;

void tp_text_add(tp_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

void tp_text_add_list(tp_text *text, const char *format, va_list arguments)
    __attribute__((format(printf, 2, 0)));

/* So many bytes as they are. */
void tp_text_append(tp_text *text, const char *bytes, size_t length);

/* Hand the text over to the caller; TP_OUT_OF_MEMORY if anything was dropped. */
TP_MUST_USE tp_status tp_text_finish(tp_text *text, char **result);

/* Give its memory back, of a text that is not handed over. */
void tp_text_drop(tp_text *text);

enum { TP_NUMBER_SIZE = 48 };

/* The number with at most `decimals` decimals, or `digits` significant digits: as many as round
 * alike over the whole of value +- error. */
const char *tp_text_fixed(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals);
const char *tp_text_significant(char out[TP_NUMBER_SIZE], tp_bounded number, int digits);

/* A factor of safety is rounded down wherever it is printed, and a utilisation or another upper
 * bound up, so that no printed number is safer than the proven one: from the lower end of value +-
 * error down, or from the upper end up, with at most `decimals` decimals or `digits` significant
 * digits and not more than the error leaves. An error that is only rounding, a billionth of the
 * last digit, does not lower a number that it reaches: 1.5 +- 1e-16 is printed as 1.500. */
const char *tp_text_fixed_down(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals);
const char *tp_text_fixed_up(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals);
const char *tp_text_significant_down(char out[TP_NUMBER_SIZE], tp_bounded number, int digits);
const char *tp_text_significant_up(char out[TP_NUMBER_SIZE], tp_bounded number, int digits);

/* The number over a positive divisor that is a double rounded to nearest (a unit). */
tp_bounded tp_text_over(tp_bounded number, double divisor);

/* One number less another: rounded, with a bound. */
tp_bounded tp_text_less(tp_bounded number, tp_bounded other);

#endif
