/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The library in programs that have set their thread up otherwise.
 *
 * A program in German printed `28,734` into JSON, found no root and drew a wrong map; one that
 * rounds downwards got bounds that do not hold; one with traps was killed. Here the whole library
 * runs once in a thread as it comes, and again in settings of a program: every byte that it says
 * must be the same, and the setting must be there as before. Each of its parts runs with everything
 * set at once and in one other setting, in turn; under ./check --long in all of them. Nothing is
 * known of the truth: that is the business of the other tests, which run in a thread as it comes.
 */

#define _GNU_SOURCE
#include "comma_locale.h"
#include "host_settings.h"
#include "sayings.h"
#include "suite.h"

#include "common/host.h"
#include "topple.h"

#include <fenv.h>
#include <flint/flint.h>
#include <locale.h>
#include <mpfr.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__SSE__)
#include <fpu_control.h>
#include <xmmintrin.h>
#endif

#define EXAMPLE(name) TP_EXAMPLES "/" name

static const char *folder;

static void make_locale(void) {
  comma_locale_make(folder);
}

static void expect_same(const sayings *first, const sayings *again, const char *part,
                        const char *set) {
  ck_assert_msg(again->count == first->count, "%s, %s: %zu texts instead of %zu", part, set,
                again->count, first->count);
  for (size_t t = 0; t < first->count; t++) {
    const char *one = first->texts[t], *other = again->texts[t];
    ck_assert(one != NULL && other != NULL);
    size_t same = 0;
    while (one[same] != '\0' && one[same] == other[same]) same++;
    const size_t from = same > 60 ? same - 60 : 0;
    ck_assert_msg(one[same] == other[same], "%s, %s, text %zu:\n%.120s\nand not\n%.120s", part, set,
                  t, other + from, one + from);
  }
}

static void expect_same_when_set(const sayings *first, const saying *part, const named_setting *s) {
  sayings again = {.folder = folder};
  s->set();
  const setting before = setting_now();
  part->say(&again);
  const setting after = setting_now();
  as_it_comes();
  ck_assert_msg(memcmp(&before, &after, sizeof before) == 0, "%s, %s: not as before", part->name,
                s->name);
  expect_same(first, &again, part->name, s->name);
  sayings_forget(&again);
}

/* Everything at once is the last of the settings. */
START_TEST(same_bytes_in_every_setting) {
  const size_t apart = (size_t)rounds(SETTINGS - 1, 1);
  size_t texts = 0;
  for (size_t p = 0; p < all_sayings_count; p++) {
    const saying *part = all_sayings + p;
    sayings first = {.folder = folder};
    part->say(&first);
    ck_assert_uint_lt(first.count, MOST_SAYINGS);
    texts += first.count;
    for (size_t k = p % apart; k < SETTINGS - 1; k += apart) {
      expect_same_when_set(&first, part, settings + k);
    }
    expect_same_when_set(&first, part, settings + SETTINGS - 1);
    sayings_forget(&first);
  }
  ck_assert_uint_gt(texts, 200);
}
END_TEST

/* The settings do what they say: a test whose comma is a point would find nothing. */
START_TEST(settings_are_set) {
  char text[16];
  volatile double third = 1, tiny = 0x1p-1022;
  decimal_comma();
  snprintf(text, sizeof text, "%g", 0.5);
  ck_assert_str_eq(text, "0,5");
  as_it_comes();
  rounding_up();
  third = third / 3;
  as_it_comes();
  ck_assert_double_gt(third, 1. / 3);
  flushing_to_zero();
  tiny = tiny / 2;
  as_it_comes();
#if defined(__SSE__)
  ck_assert(tiny == 0);
#endif
}
END_TEST

/* Sums of large blocks are shared by threads: those must round as the entry does. */
static void *rounding_here(void *result) {
  *(int *)result = fegetround();
  return NULL;
}

START_TEST(threads_round_as_the_entry) {
  int rounding = -1;
  rounding_up();
  {
    TP_GUARD_HOST;
    pthread_t thread;
    ck_assert_int_eq(pthread_create(&thread, NULL, rounding_here, &rounding), 0);
    pthread_join(thread, NULL);
  }
  const int after = fegetround();
  as_it_comes();
  ck_assert_int_eq(rounding, FE_TONEAREST);
  ck_assert_int_eq(after, FE_UPWARD);
}
END_TEST

/* Entries in several threads at once, each with a setting of its own. */
static void *solve_in_a_thread(void *argument) {
  const int which = *(const int *)argument;
  static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST};
  sayings *s = calloc(1, sizeof *s);
  fesetround(modes[which]);
  if (which % 2 == 0) decimal_comma_of_the_thread();
  const setting before = setting_now();
  if (s != NULL) say_scene(s, EXAMPLE("block_e_valley.yaml"), 30);
  const setting after = setting_now();
  if (s != NULL && memcmp(&before, &after, sizeof before) != 0) sayings_forget(s);
  give_locale_back();
  flint_cleanup();
  return s;
}

START_TEST(threads_of_different_settings) {
  enum { THREADS = 4 };
  pthread_t threads[THREADS];
  int which[THREADS];
  sayings *results[THREADS], expected = {.folder = folder};
  say_scene(&expected, EXAMPLE("block_e_valley.yaml"), 30);
  for (int k = 0; k < THREADS; k++) {
    which[k] = k;
    ck_assert_int_eq(pthread_create(threads + k, NULL, solve_in_a_thread, which + k), 0);
  }
  for (int k = 0; k < THREADS; k++) {
    void *result = NULL;
    pthread_join(threads[k], &result);
    results[k] = result;
    ck_assert_ptr_nonnull(results[k]);
    ck_assert_uint_eq(results[k]->count, expected.count);
    for (size_t t = 0; t < expected.count; t++) {
      ck_assert_msg(strcmp(results[k]->texts[t], expected.texts[t]) == 0, "text %zu differs", t);
    }
    sayings_forget(results[k]);
    free(results[k]);
  }
  sayings_forget(&expected);
}
END_TEST

SUITE(host) {
  folder = scratch_folder();
  Suite *suite = suite_create("host");
  TCase *tests = tcase_create("settings");
  tcase_set_timeout(tests, 600);
  tcase_add_unchecked_fixture(tests, make_locale, as_it_comes);
  tcase_add_test(tests, settings_are_set);
  tcase_add_test(tests, same_bytes_in_every_setting);
  tcase_add_test(tests, threads_round_as_the_entry);
  tcase_add_test(tests, threads_of_different_settings);
  suite_add_tcase(suite, tests);
  return suite;
}
