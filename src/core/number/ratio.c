/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reader of decimals, fractions and doubles into FLINT rationals with bounded digits and exponents,
 * and writer of exact decimals or fractions. */

#include "number/ratio.h"

#include "number/shortest.h"
#include "number/word.h"

#include <float.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/* value = mantissa * 10^exponent for a mantissa of one word, without a general gcd: only factors
 * of 2 and 5 can cancel. */
static void set_small_decimal(fmpq_t value, uint64_t mantissa, int exponent) {
  static const uint64_t power[19] = {1,
                                     10,
                                     100,
                                     1000,
                                     10000,
                                     100000,
                                     1000000,
                                     10000000,
                                     100000000,
                                     1000000000,
                                     10000000000,
                                     100000000000,
                                     1000000000000,
                                     10000000000000,
                                     100000000000000,
                                     1000000000000000,
                                     10000000000000000,
                                     100000000000000000,
                                     1000000000000000000};
  while (exponent < 0 && mantissa % 10 == 0) mantissa /= 10, exponent++;
  if (mantissa == 0) exponent = 0;
  if (exponent >= 0) {
    tp_word_set_unsigned(fmpq_numref(value), mantissa);
    if (exponent > 0) {
      fmpz_t ten;
      fmpz_init_set_ui(ten, 10);
      fmpz_pow_ui(ten, ten, (unsigned long)exponent);
      fmpz_mul(fmpq_numref(value), fmpq_numref(value), ten);
      fmpz_clear(ten);
    }
    fmpz_one(fmpq_denref(value));
    return;
  }
  uint64_t denominator = power[-exponent];
  while (mantissa % 2 == 0 && denominator % 2 == 0) mantissa /= 2, denominator /= 2;
  while (mantissa % 5 == 0 && denominator % 5 == 0) mantissa /= 5, denominator /= 5;
  tp_word_set_unsigned(fmpq_numref(value), mantissa);
  tp_word_set_unsigned(fmpq_denref(value), denominator);
}

static void set_large_decimal(fmpq_t value, const char *digits, long exponent) {
  fmpz_t ten;
  fmpz_set_str(fmpq_numref(value), digits, 10);
  fmpz_one(fmpq_denref(value));
  fmpz_init_set_ui(ten, 10);
  fmpz_pow_ui(ten, ten, (unsigned long)(exponent < 0 ? -exponent : exponent));
  fmpz *side = exponent < 0 ? fmpq_denref(value) : fmpq_numref(value);
  fmpz_mul(side, side, ten);
  fmpq_canonicalise(value);
  fmpz_clear(ten);
}

/* The exponent part "e-12" at `text`, if there is one; its length into `*used`. */
static long read_exponent(const char *text, size_t length, size_t *used) {
  size_t at = 1;
  bool negative = false;
  *used = 0;
  if (length < 2 || (text[0] != 'e' && text[0] != 'E')) return 0;
  if (text[at] == '+' || text[at] == '-') negative = text[at++] == '-';
  if (at >= length || !is_digit(text[at])) return 0;
  long exponent = 0;
  for (; at < length && is_digit(text[at]); at++) {
    if (exponent < 100000) exponent = 10 * exponent + (text[at] - '0');
  }
  *used = at;
  return negative ? -exponent : exponent;
}

size_t tp_ratio_read_decimal(fmpq_t value, const char *text, size_t length, const char **problem) {
  char digits[TP_RATIO_DIGITS + 1];
  size_t at = 0, count = 0, seen = 0;
  long exponent = 0;
  uint64_t mantissa = 0;
  bool point = false;
  for (; at < length; at++) {
    if (text[at] == '.' && !point) {
      point = true;
      continue;
    }
    if (!is_digit(text[at])) break;
    seen++;
    if (point) exponent--;
    if (count == 0 && text[at] == '0') continue; /* leading zeros carry nothing */
    if (count == TP_RATIO_DIGITS) {
      *problem = "has more than 1000 digits";
      return 0;
    }
    digits[count++] = text[at];
    if (count <= 18) mantissa = 10 * mantissa + (uint64_t)(text[at] - '0');
  }
  if (seen == 0) {
    *problem = "is not a number";
    return 0;
  }
  size_t used = 0;
  exponent += read_exponent(text + at, length - at, &used);
  if (count > 0 && exponent + (long)count - 1 > TP_RATIO_EXPONENT) {
    *problem = "is larger than 1e308, the largest number that Topple takes";
    return 0;
  }
  if (count > 0 && exponent + (long)count - 1 < -TP_RATIO_EXPONENT) {
    *problem = "is smaller than 1e-308, the smallest number that Topple takes";
    return 0;
  }
  digits[count] = '\0';
  if (count == 0) {
    fmpq_zero(value);
  } else if (count <= 18 && exponent >= -18) {
    set_small_decimal(value, mantissa, (int)exponent);
  } else {
    set_large_decimal(value, digits, exponent);
  }
  return at + used;
}

/* Behind the sign, from `*at` on, which ends up behind the decimal. */
static bool read_signed(fmpq_t value, size_t *at, const char *text, size_t length,
                        const char **problem) {
  const bool negative = length > 0 && text[0] == '-';
  *at = length > 0 && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const size_t used = tp_ratio_read_decimal(value, text + *at, length - *at, problem);
  *at += used;
  if (negative && used > 0) fmpq_neg(value, value);
  return used > 0;
}

/* Why a field with something behind its first number is no number. */
static const char *problem_behind(const char *text, size_t length) {
  if (length > 1 && text[0] == '/') return "is two numbers, and nothing is calculated in a field";
  if (length > 1 && text[0] == '-' && is_digit(text[1])) return "is a range, not one number";
  return "is not a number";
}

bool tp_ratio_read_field(fmpq_t value, const char *text, size_t length, const char **problem) {
  size_t at = 0;
  if (!read_signed(value, &at, text, length, problem)) return false;
  if (at == length) return true;
  *problem = problem_behind(text + at, length - at);
  return false;
}

bool tp_ratio_read_fraction(fmpq_t value, const char *text, size_t length, const char **problem) {
  size_t at = 0;
  if (!read_signed(value, &at, text, length, problem)) return false;
  if (at < length && text[at] == '/') {
    fmpq_t divisor;
    fmpq_init(divisor);
    size_t used = tp_ratio_read_decimal(divisor, text + at + 1, length - at - 1, problem);
    if (used > 0 && fmpq_is_zero(divisor)) {
      *problem = "divides by zero";
      used = 0;
    }
    if (used > 0) fmpq_div(value, value, divisor);
    fmpq_clear(divisor);
    if (used == 0) return false;
    at += 1 + used;
  }
  if (at == length) return true;
  *problem = "is not a number";
  return false;
}

bool tp_ratio_read_double(fmpq_t value, double given) {
  char text[TP_SHORTEST_SIZE];
  const char *problem = NULL;
  tp_shortest(text, given);
  return tp_ratio_read_field(value, text, strlen(text), &problem);
}

bool tp_ratio_is_not_finite(const char *text) {
  static const char *const words[] = {"nan", "inf", "infinity", NULL};
  if (*text == '+' || *text == '-') text++;
  if (*text == '.') text++;
  for (size_t k = 0; words[k] != NULL; k++) {
    if (strcasecmp(text, words[k]) == 0) return true;
  }
  return false;
}

/* The decimal text of value if it is exact with as many decimals as 64 bits take. */
static bool decimal_text(char *text, size_t size, const fmpq_t value) {
  enum { MOST_DECIMALS = 19 };
  fmpz_t scaled, ten;
  fmpz_init(scaled);
  fmpz_init_set_ui(ten, 1);
  bool found = false;
  uint64_t one = 1; /* ten as a word: 10^19 is below 2^64 */
  for (int decimals = 0; decimals <= MOST_DECIMALS && !found;
       decimals++, one *= 10, fmpz_mul_ui(ten, ten, 10)) {
    if (!fmpz_divisible(ten, fmpq_denref(value))) continue;
    fmpz_mul(scaled, ten, fmpq_numref(value));
    fmpz_divexact(scaled, scaled, fmpq_denref(value));
    if (!tp_word_fits(scaled)) break;
    const int64_t n = tp_word_get(scaled);
    const uint64_t magnitude = n < 0 ? 0 - (uint64_t)n : (uint64_t)n;
    if (decimals == 0) {
      snprintf(text, size, "%" PRId64, n);
    } else {
      snprintf(text, size, "%s%" PRIu64 ".%0*" PRIu64, n < 0 ? "-" : "", magnitude / one, decimals,
               magnitude % one);
    }
    found = true;
  }
  fmpz_clear(scaled);
  fmpz_clear(ten);
  return found;
}

/* Is it the value of a double, which somebody wrote as a decimal? Its numerator is odd or its
 * denominator 1. */
static bool is_double(const fmpq_t value) {
  const fmpz *denominator = fmpq_denref(value);
  if (fmpz_bits(denominator) != fmpz_val2(denominator) + 1) return false;
  return fmpz_bits(fmpq_numref(value)) - fmpz_val2(fmpq_numref(value)) <= DBL_MANT_DIG;
}

void tp_ratio_text(char *text, size_t size, const fmpq_t value) {
  if (decimal_text(text, size, value)) return;
  if (is_double(value)) {
    char decimal[TP_SHORTEST_SIZE];
    snprintf(text, size, "%s", tp_shortest(decimal, fmpq_get_d(value)));
    return;
  }
  if (fmpz_bits(fmpq_numref(value)) > 60 || fmpz_bits(fmpq_denref(value)) > 60) {
    snprintf(text, size, "%.17g", fmpq_get_d(value));
    return;
  }
  snprintf(text, size, "%" PRId64 "/%" PRId64, tp_word_get(fmpq_numref(value)),
           tp_word_get(fmpq_denref(value)));
}

/* How many decimals the value has; -1: no end of them. */
static long count_decimals(const fmpq_t value) {
  fmpz_t rest, five;
  fmpz_init_set(rest, fmpq_denref(value));
  fmpz_init_set_ui(five, 5);
  const long twos = (long)fmpz_val2(rest), fives = fmpz_remove(rest, rest, five);
  fmpz_tdiv_q_2exp(rest, rest, (unsigned long)twos);
  const bool ends = fmpz_is_one(rest);
  fmpz_clear(rest);
  fmpz_clear(five);
  return !ends ? -1 : twos > fives ? twos : fives;
}

/* The digits of value * 10^decimals, allocated by malloc, with or without a sign. */
static char *scaled_digits(const fmpq_t value, long decimals) {
  fmpz_t scaled;
  fmpz_init_set_ui(scaled, 10);
  fmpz_pow_ui(scaled, scaled, (unsigned long)decimals);
  fmpz_mul(scaled, scaled, fmpq_numref(value));
  fmpz_divexact(scaled, scaled, fmpq_denref(value));
  const size_t size = fmpz_sizeinbase(scaled, 10) + 2; /* a sign, and its end */
  char *digits = size <= TP_RATIO_DIGITS + 2 ? malloc(size) : NULL;
  if (digits != NULL) fmpz_get_str(digits, 10, scaled);
  fmpz_clear(scaled);
  return digits;
}

/* A point among the digits, or an exponent behind them where many zeros would stand before. */
static char *place_point(const char *digits, long decimals) {
  enum { MOST_ZEROS = 6 };
  const char *sign = *digits == '-' ? "-" : "";
  digits += *digits == '-' ? 1 : 0;
  const long count = (long)strlen(digits), whole = count - decimals;
  const size_t size = (size_t)count + MOST_ZEROS + 32;
  char *text = malloc(size);
  if (text == NULL) return NULL;
  if (whole > 0) {
    snprintf(text, size, "%s%.*s.%s", sign, (int)whole, digits, digits + whole);
  } else if (-whole < MOST_ZEROS) {
    snprintf(text, size, "%s0.%.*s%s", sign, (int)-whole, "000000", digits);
  } else {
    snprintf(text, size, "%s%se-%ld", sign, digits, decimals);
  }
  return text;
}

/* Decimals that have more digits than can be read are told as a fraction, too. */
char *tp_ratio_exact_text(const fmpq_t value) {
  const long decimals = count_decimals(value);
  char *digits = decimals >= 0 ? scaled_digits(value, decimals) : NULL;
  if (digits != NULL) {
    char *text = decimals > 0 ? place_point(digits, decimals) : strdup(digits);
    free(digits);
    return text;
  }
  char *text =
      malloc(fmpz_sizeinbase(fmpq_numref(value), 10) + fmpz_sizeinbase(fmpq_denref(value), 10) + 3);
  if (text != NULL) fmpq_get_str(text, 10, value);
  return text;
}
