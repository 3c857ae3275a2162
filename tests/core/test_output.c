/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Texts that grow, and the numbers in them: every digit that is printed is certain, and where none
 * is, value and bound hold what the number does. */

#include "output/encode.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void prints(tp_text *t, const char *expected) {
  char *text = NULL;
  ck_assert_int_eq(tp_text_finish(t, &text), TP_OK);
  ck_assert_str_eq(text, expected);
  free(text);
}

START_TEST(a_text_grows) {
  enum { PIECES = 30000 };
  tp_text t = {0};
  char *text = NULL;
  for (int k = 0; k < PIECES; k++) {
    tp_text_add(&t, "%05d", k);
    tp_text_append(&t, ";!", 1);
    ck_assert_uint_eq(strlen(t.data), t.length);
  }
  tp_text_add(&t, "%10000s", "end");
  ck_assert_uint_eq(t.length, 6 * PIECES + 10000);
  ck_assert_int_eq(tp_text_finish(&t, &text), TP_OK);
  for (int k = 0; k < PIECES; k++) {
    char piece[16];
    snprintf(piece, sizeof piece, "%05d;", k);
    ck_assert_int_eq(strncmp(text + 6 * (size_t)k, piece, 6), 0);
  }
  ck_assert_str_eq(text + 6 * PIECES + 9997, "end");
  ck_assert_ptr_null(t.data);
  free(text);
}
END_TEST

START_TEST(nothing_is_a_text_too) {
  tp_text t = {0};
  char *text = NULL;
  tp_text_add(&t, "%s", "");
  prints(&t, "");
  tp_text_append(&t, "", 0);
  prints(&t, "");
  ck_assert_int_eq(tp_text_finish(&t, &text), TP_OUT_OF_MEMORY); /* nothing was added */
  tp_text_add(&t, "dropped");
  tp_text_drop(&t);
  ck_assert_ptr_null(t.data);
}
END_TEST

START_TEST(columns_count_characters) {
  tp_text t = {0};
  tp_encode_column(&t, "Böschung", 10);
  tp_encode_column(&t, "longer than that", 4);
  prints(&t, "Böschung  longer than that");
}
END_TEST

START_TEST(digits_of_a_number) {
  static const struct {
    tp_bounded number;
    int decimals;
    const char *fixed;
    int digits;
    const char *significant;
  } cases[] = {{{.value = 28.73451, .error = 1e-9}, 3, "28.735", 4, "28.73"},
               {{.value = 28.73451, .error = 1e-4}, 6, "28.73", 9, "28.73"},
               {{.value = 0.9995, .error = 1e-3}, 3, "1.00", 3, "1"},
               {{.value = -1e-9, .error = 1e-10}, 3, "0.000", 1, "-1e-09 ± 2e-10"},
               {{.value = 0}, 2, "0.00", 5, "0"},
               {{.value = 5, .error = 3}, 2, "5 ± 4", 3, "5 ± 4"},
               {{.value = 0.001, .error = 1}, 0, "0 ± 2", 2, "0 ± 2"},
               {{.value = 1, .error = INFINITY}, 3, "out of range", 3, "out of range"},
               {{.value = 1e300}, 3, "1e+300", 3, "1e+300"}};
  char out[TP_NUMBER_SIZE];
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    ck_assert_str_eq(tp_text_fixed(out, cases[k].number, cases[k].decimals), cases[k].fixed);
    ck_assert_str_eq(tp_text_significant(out, cases[k].number, cases[k].digits),
                     cases[k].significant);
  }
}
END_TEST

/* Both ends of the number lie within half a unit of the last printed place, or within the bound. */
static void holds(const char *printed, tp_bounded number) {
  char *end = NULL;
  const double value = strtod(printed, &end);
  const char *point = strchr(printed, '.');
  double off = 0.5 * pow(10, point != NULL ? -(double)strspn(point + 1, "0123456789") : 0);
  if (*end != '\0') off = strtod(end + strlen(" ± "), NULL);
  const double room = off + 1e-12 * fabs(value);
  ck_assert_msg(fabs(value - number.value) + number.error <= room, "%s of %.17g +- %.17g", printed,
                number.value, number.error);
}

START_TEST(printed_digits_are_certain) {
  random_numbers state = random_numbers_from(1);
  for (int k = 0; k < 100000; k++) {
    char out[TP_NUMBER_SIZE];
    const double value = (draw_part(&state) - 0.5) * pow(10, (double)draw_below(&state, 7) - 2);
    const double error = k % 10 == 0 ? 0 : pow(10, 12 * draw_part(&state) - 9);
    const tp_bounded number = {.value = value, .error = error};
    holds(tp_text_fixed(out, number, (int)draw_below(&state, 8)), number);
  }
}
END_TEST

/* "1.05" was printed for a factor of 1.0495407, above "the required 1.05 is not met". */
START_TEST(factors_are_rounded_down) {
  static const struct {
    tp_bounded number;
    int decimals;
    const char *down, *up;
    int digits;
    const char *significant_down, *significant_up;
  } cases[] = {
      {{.value = 1.0495407, .error = 1e-9}, 3, "1.049", "1.050", 3, "1.04", "1.05"},
      {{.value = 1.05, .error = 1e-15}, 3, "1.050", "1.050", 3, "1.05", "1.05"},
      {{.value = 1.5, .error = 0}, 0, "1", "2", 1, "1", "2"},
      {{.value = 9.9996, .error = 0}, 3, "9.999", "10.000", 4, "9.999", "10"},
      {{.value = 1.506, .error = 0.01}, 3, "1.49", "1.52", 4, "1.49", "1.52"},
      {{.value = 12345.6, .error = 0}, 3, "12345.600", "12345.600", 4, "1.234e+04", "1.235e+04"},
      {{.value = -0.2501, .error = 1e-9}, 2, "-0.26", "-0.25", 2, "-0.26", "-0.25"},
      {{.value = 0.0004, .error = 1e-9}, 3, "0.000", "0.001", 1, "0.0003", "0.0005"},
      {{.value = 5, .error = 3}, 2, "5 ± 4", "5 ± 4", 3, "5 ± 4", "5 ± 4"},
      {{.value = 1, .error = INFINITY},
       3,
       "out of range",
       "out of range",
       3,
       "out of range",
       "out of range"}};
  char out[TP_NUMBER_SIZE];
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    const tp_bounded n = cases[k].number;
    ck_assert_str_eq(tp_text_fixed_down(out, n, cases[k].decimals), cases[k].down);
    ck_assert_str_eq(tp_text_fixed_up(out, n, cases[k].decimals), cases[k].up);
    ck_assert_str_eq(tp_text_significant_down(out, n, cases[k].digits), cases[k].significant_down);
    ck_assert_str_eq(tp_text_significant_up(out, n, cases[k].digits), cases[k].significant_up);
  }
}
END_TEST

/* The printed number is not beyond the proven end, nor short of it by more than one of its last
 * place; ends are compared as long doubles, whose rounding is below what is allowed as noise. */
START_TEST(no_rounded_number_is_beyond_its_proven_end) {
  random_numbers state = random_numbers_from(3);
  for (int k = 0; k < 100000; k++) {
    char out[TP_NUMBER_SIZE], *end = NULL;
    const bool fixed = draw_below(&state, 2) == 0, down = draw_below(&state, 2) == 0;
    const int digits = 1 + (int)draw_below(&state, 7);
    /* whole multiples of the last place, so that numbers on the border are met */
    const double near = (double)draw_below(&state, 3000) / pow(10, digits);
    const double value = draw_below(&state, 2) == 0 ? near : 30 * draw_part(&state);
    const double error = k % 10 == 0 ? 0 : pow(10, 14 * draw_part(&state) - 17);
    const tp_bounded n = {.value = value, .error = error};
    const char *printed =
        fixed  ? down ? tp_text_fixed_down(out, n, digits) : tp_text_fixed_up(out, n, digits)
         : down ? tp_text_significant_down(out, n, digits)
               : tp_text_significant_up(out, n, digits);
    const long double got = strtold(printed, &end);
    if (*end != '\0') continue; /* with its bound */
    const long double proven = (long double)value + (down ? -1 : 1) * (long double)error;
    const double greatest = fmax(fabs(value), fabs((double)proven));
    const double size = fixed ? 1 : greatest > 0 ? pow(10, floor(log10(greatest)) + 1) : 1;
    const long double place = size * pow(10, -digits);
    const long double short_of = down ? proven - got : got - proven;
    ck_assert_msg(short_of >= -3e-9L * place, "%s of %.17g +- %.17g", printed, value, error);
    ck_assert_msg(short_of <= 1.001L * fmaxl(10 * error, 10 * place), "%s of %.17g +- %.17g",
                  printed, value, error);
    if (fixed && error < 0.01 * place) ck_assert(short_of <= 1.001L * place);
  }
}
END_TEST

/* A quotient and a difference hold those of all numbers within the bounds. */
START_TEST(bounds_of_what_is_reckoned_for_print) {
  random_numbers state = random_numbers_from(2);
  for (int k = 0; k < 100000; k++) {
    const tp_bounded a = {.value = 1e6 * draw_part(&state), .error = 1e-3 * draw_part(&state)};
    const tp_bounded b = {.value = 1e6 * draw_part(&state), .error = 1e-3 * draw_part(&state)};
    const double unit = 1e-3 + 1e3 * draw_part(&state);
    const tp_bounded over = tp_text_over(a, unit), less = tp_text_less(a, b);
    for (int side = -1; side <= 1; side += 2) {
      const long double end = (long double)a.value + side * (long double)a.error;
      const long double other = (long double)b.value - side * (long double)b.error;
      ck_assert(fabsl(end / unit - over.value) <= over.error);
      ck_assert(fabsl(end - other - less.value) <= less.error);
    }
  }
}
END_TEST

SUITE(output) {
  Suite *suite = suite_create("output");
  TCase *tests = tcase_create("text");
  tcase_add_test(tests, a_text_grows);
  tcase_add_test(tests, nothing_is_a_text_too);
  tcase_add_test(tests, columns_count_characters);
  tcase_add_test(tests, digits_of_a_number);
  tcase_add_test(tests, printed_digits_are_certain);
  tcase_add_test(tests, factors_are_rounded_down);
  tcase_add_test(tests, no_rounded_number_is_beyond_its_proven_end);
  tcase_add_test(tests, bounds_of_what_is_reckoned_for_print);
  suite_add_tcase(suite, tests);
  return suite;
}
