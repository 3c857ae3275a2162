/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sweeps: exact values in their order, the same by any number of threads, each point what a scene
 * by settings says; a point that is wrong costs itself alone, and the one who takes them may stop.
 */

#include "varied_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, TEXT_SIZE = 1 << 20 };

/* What was taken. */
typedef struct taken {
  size_t count, most;
  char numbers[MOST][2][24]; /* x, and y */
  tp_status statuses[MOST];
  double moments_deg[MOST];
  char message[200];
} taken;

static bool take(void *context, const tp_sweep_point *point) {
  taken *own = context;
  ck_assert_uint_eq(point->index, own->count);
  for (size_t k = 0; k < point->set->count && k < 2; k++) {
    snprintf(own->numbers[own->count][k], 24, "%s", point->set->items[k].formula);
  }
  own->statuses[own->count] = point->status;
  ck_assert_int_eq(point->solution != NULL, point->message[0] == '\0');
  if (point->solution != NULL) {
    const tp_case *c = point->solution->cases;
    own->moments_deg[own->count] = c->pivots[c->toppling_pivot].critical_angle_deg.value;
  } else {
    snprintf(own->message, sizeof own->message, "%.199s", point->message);
  }
  return ++own->count < own->most;
}

static tp_sweep_summary swept(taken *own, const tp_scene *scene, const char *x, const char *y) {
  tp_sweep_options options = tp_sweep_options_default();
  tp_sweep_summary summary = {.count = 0};
  options.x = x;
  options.y = y;
  *own = (taken){.most = MOST};
  DO(tp_sweep(&summary, scene, &options, (tp_sweep_sink){take, own}, &message));
  return summary;
}

/* Decimals stay decimals, fractions fractions; down, and to a last value that no step meets. */
START_TEST(exact_values) {
  static const struct {
    const char *axis, *values[7];
  } cases[] = {{"a=1:1.5:0.1", {"1", "1.1", "1.2", "1.3", "1.4", "1.5"}},
               {"a=1:2:0.3", {"1", "1.3", "1.6", "1.9"}},
               {"a=2:1:-1/3", {"2", "5/3", "4/3", "1"}},
               {"a=c:2*c:c/4", {"1", "1.25", "1.5", "1.75", "2"}},
               {"a=3:3:1", {"3"}},
               {"a=7,1e-3,2*c", {"7", "0.001", "2"}},
               {"parameters.a=4", {"4"}}};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  taken own;
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    const tp_sweep_summary sum = swept(&own, scene, cases[k].axis, NULL);
    size_t count = 0;
    for (; cases[k].values[count] != NULL; count++) {
      ck_assert_str_eq(own.numbers[count][0], cases[k].values[count]);
    }
    ck_assert_uint_eq(sum.count, count);
    ck_assert_uint_eq(own.count, count);
    ck_assert_uint_eq(sum.done, count);
  }
  tp_scene_free(scene);
}
END_TEST

/* x runs fastest. Of a slab of width a and height b the critical angle is atan(a / b). */
START_TEST(two_numbers) {
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST), *built = slab(3);
  taken own;
  const tp_sweep_summary sum = swept(&own, scene, "a=1:3:0.5", "b=4,8,16");
  ck_assert_uint_eq(sum.count, 15);
  for (size_t k = 0; k < 15; k++) {
    const double a = 1 + 0.5 * (double)(k % 5), b = (double)(4 << (k / 5));
    ck_assert_double_eq(strtod(own.numbers[k][0], NULL), a);
    ck_assert_double_eq(strtod(own.numbers[k][1], NULL), b);
    ck_assert_double_eq_tol(own.moments_deg[k], atan(a / b) * 180 / acos(-1), 1e-12);
  }
  (void)swept(&own, built, "block.outline.3.2=4,8", "block.outline.4.2=4,8");
  ck_assert_uint_eq(own.count, 4); /* in memory too */
  tp_scene_free(scene);
  tp_scene_free(built);
}
END_TEST

/* It is told, with its numbers, and the others go on. */
START_TEST(wrong_points) {
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  taken own;
  const tp_sweep_summary sum = swept(&own, scene, "friction_angle_deg=80:95:5", "a=0,1");
  ck_assert_uint_eq(sum.done, 2);
  ck_assert_uint_eq(sum.bad, 6);
  for (size_t k = 0; k < 8; k++) {
    ck_assert_int_eq(own.statuses[k], k == 4 || k == 5 ? TP_OK : TP_BAD_INPUT);
    ck_assert_str_eq(own.numbers[k][1], k < 4 ? "0" : "1");
  }
  ck_assert_ptr_nonnull(strstr(own.message, "friction_angle_deg=95: friction_angle_deg must lie"));
  tp_scene_free(scene);
}
END_TEST

START_TEST(stopped) {
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  taken own = {.most = 3};
  tp_sweep_options options = tp_sweep_options_default();
  tp_sweep_summary sum;
  options.x = "a=1:60:0.5";
  DO(tp_sweep(&sum, scene, &options, (tp_sweep_sink){take, &own}, &message));
  ck_assert_uint_eq(own.count, 3);
  ck_assert_uint_eq(sum.done, 3);
  ck_assert_uint_eq(sum.count, 119);
  tp_scene_free(scene);
}
END_TEST

static bool keep(void *context, const char *text) {
  char *all = context;
  ck_assert_uint_lt(strlen(all) + strlen(text), TEXT_SIZE);
  strcat(all, text);
  return true;
}

/* Of more points than are kept at once. */
START_TEST(threads) {
  static const size_t counts[] = {1, 2, 7};
  static const tp_sweep_format formats[] = {TP_SWEEP_CSV, TP_SWEEP_JSON};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  char *first = malloc(TEXT_SIZE), *other = malloc(TEXT_SIZE);
  for (int k = 0; k < 6; k++) {
    char *text = k % 3 == 0 ? first : other;
    tp_sweep_options options = tp_sweep_options_default();
    tp_sweep_summary summary;
    text[0] = '\0';
    options.x = "a=0.5:30:1/3";
    options.y = "b=3,0,9";
    options.threads = counts[k % 3];
    DO(tp_sweep_write(&summary, scene, &options, formats[k / 3], (tp_text_sink){keep, text},
                      &message));
    ck_assert_uint_eq(summary.count, 3 * 89);
    ck_assert_uint_eq(summary.bad, 89);
    if (text == other) ck_assert_str_eq(other, first);
  }
  free(first);
  free(other);
  tp_scene_free(scene);
}
END_TEST

START_TEST(refused) {
  static const char *const cases[][2] = {
      {"a", "'a' sweeps nothing; write KEY=FIRST:LAST:STEP"},
      {"a=", "sweeps nothing"},
      {"=1", "sweeps nothing"},
      {"a=1:2", "a=1:2: a range is written FIRST:LAST:STEP, as 20:40:0.5"},
      {"a=1:2:3:4", "a range is written"},
      {"a=1:2:0", "the step must not be 0"},
      {"a=1:2:-1", "the step leads away from the last value"},
      {"a=2:1:1", "the step leads away from the last value"},
      {"a=0:1:1e-9", "more than 100 million values"},
      {"a=0:1e300:1e-300", "more than 100 million values"},
      {"a=1,,2", "a=1,,2: a number"},
      {"a=1:x:2", "unknown name 'x'"},
      {"q=1,2", "there is no 'q' here"},
      {"tilt=1,2", "this is a list or a map"}};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  taken own = {.most = MOST};
  tp_sweep_options options = tp_sweep_options_default();
  tp_sweep_summary summary;
  const tp_sweep_sink sink = {take, &own};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    options.x = cases[k][0];
    ck_assert_int_eq(tp_sweep(&summary, scene, &options, sink, &message), TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, cases[k][1]) != NULL, "'%s'", message.text);
  }
  options.x = "a=1,2";
  options.y = "parameters.a=1,2";
  ck_assert_int_eq(tp_sweep(&summary, scene, &options, sink, &message), TP_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(message.text, "x and y sweep the same number"));
  options.x = "b=0:1:1e-5";
  options.y = "a=0:1:1e-5";
  ck_assert_int_eq(tp_sweep(&summary, scene, &options, sink, &message), TP_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(message.text, "at most 100 million"));
  ck_assert_uint_eq(own.count, 0);
  tp_scene_free(scene);
}
END_TEST

SUITE(sweep) {
  Suite *suite = suite_create("sweep");
  TCase *tests = tcase_create("sweep");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, exact_values);
  tcase_add_test(tests, two_numbers);
  tcase_add_test(tests, wrong_points);
  tcase_add_test(tests, stopped);
  tcase_add_test(tests, threads);
  tcase_add_test(tests, refused);
  suite_add_tcase(suite, tests);
  return suite;
}
