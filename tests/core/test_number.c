/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers: exact reading of decimals, signs of roots, and the ladder. The references are written
 * out by hand or computed with GMP's rationals, which the code under test does not use. */

#include "number/ladder.h"
#include "number/ratio.h"
#include "number/surd.h"
#include "random_numbers.h"
#include "suite.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool read_fraction(fmpq_t value, const char *text) {
  const char *problem = NULL;
  return tp_ratio_read_fraction(value, text, strlen(text), &problem);
}

/* Decimal text is the truth: every spelling of a number is the rational that it says. */
START_TEST(decimals_are_exact) {
  static const struct {
    const char *text, *value;
  } cases[] = {{"0.1", "1/10"},
               {"1/3", "1/3"},
               {"-2.50", "-5/2"},
               {"+.5", "1/2"},
               {"5.", "5"},
               {"0", "0"},
               {"000.000", "0"},
               {"1e3", "1000"},
               {"12.5e-1", "5/4"},
               {"0.1e1", "1"},
               {"123456789012345678901234567890", "123456789012345678901234567890"},
               {"0.30000000000000004", "7500000000000001/25000000000000000"},
               {"1e-20", "1/100000000000000000000"},
               {"4/0.5", "8"}};
  fmpq_t value;
  fmpq_init(value);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    ck_assert_msg(read_fraction(value, cases[k].text), "%s", cases[k].text);
    char *text = fmpq_get_str(NULL, 10, value);
    ck_assert_str_eq(text, cases[k].value);
    ck_assert(fmpq_is_canonical(value));
    flint_free(text);
  }
  fmpq_clear(value);
}
END_TEST

/* A random mantissa and exponent, read as text and built with GMP, are the same rational. */
START_TEST(random_decimals_agree_with_gmp) {
  fmpq_t value;
  mpq_t expected, found;
  mpz_t power;
  fmpq_init(value);
  mpq_inits(expected, found, NULL);
  mpz_init(power);
  random_numbers state = random_numbers_from(7);
  for (int k = 0; k < 5000; k++) {
    const unsigned long mantissa = draw(&state) >> (3 + k % 60);
    const int exponent = (int)draw_below(&state, 64) - 32;
    char text[64];
    snprintf(text, sizeof text, "%lue%d", mantissa, exponent);
    ck_assert(read_fraction(value, text));
    mpz_ui_pow_ui(power, 10, (unsigned long)abs(exponent));
    mpq_set_ui(expected, mantissa, 1);
    mpq_set_z(found, power);
    if (exponent < 0) {
      mpq_div(expected, expected, found);
    } else {
      mpq_mul(expected, expected, found);
    }
    fmpq_get_mpq(found, value);
    ck_assert_msg(mpq_equal(found, expected), "%s", text);
  }
  fmpq_clear(value);
  mpq_clears(expected, found, NULL);
  mpz_clear(power);
}
END_TEST

/* What is no number is refused, with a reason; so are numbers that no double can report. */
START_TEST(no_numbers) {
  static const char *const texts[] = {"",      "-",      "x",    "1x",  "1..2", "1e",
                                      "1e+",   "--1",    "1/0",  "1/",  "nan",  "inf",
                                      "1e400", "1e-400", "0x10", "1 2", "1,2"};
  fmpq_t value;
  fmpq_init(value);
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
    const char *problem = NULL;
    ck_assert_msg(!tp_ratio_read_fraction(value, texts[k], strlen(texts[k]), &problem), "%s",
                  texts[k]);
    ck_assert_ptr_nonnull(problem);
  }
  fmpq_clear(value);
}
END_TEST

/* A field of a file is data: `30/120` may be a dip and its direction, and is no quotient. */
START_TEST(fields_are_plain) {
  static const struct {
    const char *text, *problem;
  } cases[] = {{"30/120", "two numbers"}, {"1/3", "two numbers"},  {"-1/2", "two numbers"},
               {"4/0.5", "two numbers"},  {"35-28", "a range"},    {"2*3", "not a number"},
               {"(3)", "not a number"},   {"1+1", "not a number"}, {"2^3", "not a number"},
               {"1/", "not a number"},    {"1-", "not a number"},  {"1,5", "not a number"}};
  fmpq_t value;
  fmpq_init(value);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    const char *text = cases[k].text, *problem = NULL;
    ck_assert_msg(!tp_ratio_read_field(value, text, strlen(text), &problem), "%s", text);
    ck_assert_msg(strstr(problem, cases[k].problem) != NULL, "%s: %s", text, problem);
  }
  const char *problem = NULL;
  ck_assert(tp_ratio_read_field(value, "-2.50e1", 7, &problem));
  ck_assert_int_eq(fmpq_cmp_si(value, -25), 0);
  fmpq_clear(value);
}
END_TEST

/* A value shown in a message reads back as itself, or is clearly rounded; one that came in as the
 * double nearest to a decimal is shown as that decimal. */
START_TEST(texts_of_values) {
  static const char *const values[] = {"5/2",
                                       "-1/8",
                                       "1/3",
                                       "1000000",
                                       "-7/1000",
                                       "314914036505897/562949953421312",
                                       "-3602879701896397/36028797018963968",
                                       "5/36028797018963968"};
  static const char *const texts[] = {"2.5",    "-0.125",
                                      "1/3",    "1000000",
                                      "-0.007", "0.5593997025703903",
                                      "-0.1",   "1.3877787807814457e-16"};
  fmpq_t value;
  fmpq_init(value);
  for (size_t k = 0; k < sizeof values / sizeof values[0]; k++) {
    char text[64];
    fmpq_set_str(value, values[k], 10);
    tp_ratio_text(text, sizeof text, value);
    ck_assert_str_eq(text, texts[k]);
  }
  fmpq_clear(value);
}
END_TEST

static tp_status certain_at(void *context, tp_rung rung, bool *certain) {
  const tp_level *enough = context;
  *certain = rung.level >= *enough;
  return TP_OK;
}

static tp_status never_certain(void *context, tp_rung rung, bool *certain) {
  long *last_bits = context;
  ck_assert_int_gt(rung.bits, *last_bits); /* every rung is finer than the one before */
  *last_bits = rung.bits;
  *certain = false;
  return TP_OK;
}

static tp_status fails(void *context, tp_rung rung, bool *certain) {
  (void)context;
  (void)rung;
  *certain = true;
  return TP_OUT_OF_MEMORY;
}

/* The ladder stops at the first rung that is certain, says undecided past the last, passes failures
 * on; no rung lies above the level allowed, and the last has twice the bits that the digits
 * take. */
START_TEST(ladder) {
  tp_rung reached;
  for (tp_level level = TP_LEVEL_DOUBLE; level <= TP_LEVEL_EXACT; level++) {
    ck_assert_int_eq(tp_ladder_climb(certain_at, &level, TP_LEVEL_EXACT, 9, &reached), TP_OK);
    ck_assert_int_eq(reached.level, level);
  }
  for (tp_level highest = TP_LEVEL_DOUBLE; highest <= TP_LEVEL_EXACT; highest++) {
    for (int digits = 1; digits <= TP_DIGITS_MAX; digits += 111) {
      long bits = 0;
      ck_assert_int_eq(tp_ladder_climb(never_certain, &bits, highest, digits, &reached),
                       TP_UNDECIDED);
      ck_assert_int_eq(reached.level, highest);
      ck_assert(highest < TP_LEVEL_BALL || (double)bits > 2 * 3.32 * digits);
    }
  }
  ck_assert_int_eq(tp_ladder_climb(fails, NULL, TP_LEVEL_EXACT, 9, &reached), TP_OUT_OF_MEMORY);
}
END_TEST

/* c0 + c1 sqrt(d1) + …, from text. */
static int sign_of_roots(const char *whole, long count, const char *const (*terms)[2]) {
  tp_surd sum;
  fmpq_t factor;
  fmpz_t radicand;
  tp_surd_init(&sum);
  fmpq_init(factor);
  fmpz_init(radicand);
  ck_assert_int_eq(fmpq_set_str(sum.c, whole, 10), 0);
  for (long k = 0; k < count; k++) {
    ck_assert_int_eq(fmpq_set_str(factor, terms[k][0], 10), 0);
    ck_assert_int_eq(fmpz_set_str(radicand, terms[k][1], 10), 0);
    tp_surd_add_root(&sum, factor, radicand);
  }
  const int sign = tp_surd_sign(&sum);
  tp_surd_clear(&sum);
  fmpq_clear(factor);
  fmpz_clear(radicand);
  return sign;
}

/* Sums of roots that vanish though no part does, and sums that nearly do: with the continued
 * fraction p / q of sqrt(2) (p^2 - 2 q^2 = 1 or -1) p - q sqrt(2) is as small as 1 / (2 p), of the
 * sign of p^2 - 2 q^2. */
START_TEST(signs_of_roots) {
  static const char *const zero[][2] = {{"1", "8"}, {"-2", "2"}, {"3/7", "12"}, {"-6/7", "3"}};
  static const char *const squares[][2] = {{"2/3", "49"}, {"-1", "4"}};
  ck_assert_int_eq(sign_of_roots("0", 0, NULL), 0);
  ck_assert_int_eq(sign_of_roots("-1/1000000", 0, NULL), -1);
  ck_assert_int_eq(sign_of_roots("0", 4, zero), 0);
  ck_assert_int_eq(sign_of_roots("1/999999999999999999999999999999999999999999", 4, zero), 1);
  ck_assert_int_eq(sign_of_roots("-8/3", 2, squares), 0);
  mpz_t p, q, held;
  mpz_init_set_ui(p, 1);
  mpz_init_set_ui(q, 1);
  mpz_init(held);
  for (int k = 0; k < 2000; k++) { /* p^2 - 2 q^2 = -1, 1, -1, … */
    if (k % 97 < 2) {
      char whole[2000], factor[2000] = "-";
      mpz_get_str(whole, 10, p);
      mpz_get_str(factor + 1, 10, q);
      const char *const term[][2] = {{factor, "2"}};
      ck_assert_int_eq(sign_of_roots(whole, 1, term), k % 2 == 0 ? -1 : 1);
    }
    mpz_addmul_ui(p, q, 2); /* p + 2 q, p + q */
    mpz_sub(held, p, q);
    mpz_swap(q, held);
  }
  mpz_clears(p, q, held, NULL);
}
END_TEST

SUITE(number) {
  Suite *suite = suite_create("number");
  TCase *numbers = tcase_create("number");
  tcase_add_test(numbers, decimals_are_exact);
  tcase_add_test(numbers, random_decimals_agree_with_gmp);
  tcase_add_test(numbers, no_numbers);
  tcase_add_test(numbers, fields_are_plain);
  tcase_add_test(numbers, texts_of_values);
  tcase_add_test(numbers, ladder);
  tcase_add_test(numbers, signs_of_roots);
  suite_add_tcase(suite, numbers);
  return suite;
}
