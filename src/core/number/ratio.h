/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact rationals from text, and back.
 *
 * Decimal text is the truth: "0.1" is one tenth. Numbers are bounded in size before they reach
 * FLINT, which aborts when memory is exhausted: at most TP_RATIO_DIGITS digits, magnitude between
 * 1e-308 and 1e308 (the range of a double, so that every input can be reported back). */

#ifndef TP_NUMBER_RATIO_H
#define TP_NUMBER_RATIO_H

#include <flint/fmpq.h>
#include <stdbool.h>
#include <stddef.h>

enum { TP_RATIO_DIGITS = 1000, TP_RATIO_EXPONENT = 308 };

/* Read an unsigned decimal, `digits[.digits][e[+-]digits]`, from the front of `text`. Returns the
 * number of characters read, 0 with `*problem` set (a static string) where there is no number. */
size_t tp_ratio_read_decimal(fmpq_t value, const char *text, size_t length, const char **problem);

/* Read a whole field of a file, `[+-]decimal`; false with `*problem` set where it is none. A field
 * is data: nothing is calculated in it, as `30/120` may be a dip and its direction. */
bool tp_ratio_read_field(fmpq_t value, const char *text, size_t length, const char **problem);

/* The same, or a quotient `[+-]decimal/decimal`: of what a caller, or a formula, writes. */
bool tp_ratio_read_fraction(fmpq_t value, const char *text, size_t length, const char **problem);

/* The shortest decimal that names a double, exactly; false: outside of the range above, or not
 * finite. */
bool tp_ratio_read_double(fmpq_t value, double given);

/* Does `text` spell infinity or not-a-number, with or without a sign and the dot of YAML? */
bool tp_ratio_is_not_finite(const char *text);

/* Shortest readable text of a value for messages: an integer, a decimal that is exact, the shortest
 * decimal that names a double, or p/q. */
void tp_ratio_text(char *text, size_t size, const fmpq_t value);

/* All of its digits, as tp_ratio_read_fraction takes them: a decimal, or p/q. Allocated with
 * malloc; NULL when memory is exhausted. */
char *tp_ratio_exact_text(const fmpq_t value);

#endif
