/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results of a solid that contradict themselves are an error (solid_tilt/results_check.h).
 *
 * A tube was once reported with shares that summed to -1 and a least tilt of -82.15 degrees, at
 * exit status 0. Here the results of an example are changed by one number at a time, and each is
 * refused.
 */

#include "solid_tilt/results_check.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static tp_message message;
static tp_solid *solid;

static void begin(void) {
  const double bands[] = {0.01};
  tp_solid_options options = tp_solid_options_default();
  options.bands = bands;
  options.band_count = 1;
  ck_assert_int_eq(
      tp_solid_of_file(&solid, TP_EXAMPLES "/solids/balanced_rock.obj", &options, &message), TP_OK);
  ck_assert_uint_gt(solid->pose_count, 2);
  ck_assert(solid->bands[0].stands && solid->bands[0].rose_count > 1);
  ck_assert_int_eq(tp_solid_results_check(solid, &message), TP_OK);
}

static void end(void) {
  tp_solid_free(solid);
}

/* With another number in place of one, the results are refused, and `words` say why. */
static void expect(double *number, double other, const char *words) {
  const double kept = *number;
  *number = other;
  ck_assert_int_eq(tp_solid_results_check(solid, &message), TP_DEPENDENCY_FAILED);
  ck_assert_msg(strstr(message.text, words) != NULL, "%s", message.text);
  *number = kept;
  ck_assert_int_eq(tp_solid_results_check(solid, &message), TP_OK);
}

START_TEST(each_contradiction_is_refused) {
  tp_solid_pose *pose = solid->poses + 1;
  tp_solid_band *band = solid->bands;
  expect(&pose->share.value, -0.0028, "not between 0 and 1");
  expect(&pose->share.value, 1.5, "not between 0 and 1");
  expect(&pose->share.value, NAN, "not between 0 and 1");
  expect(&pose->facet_share.value, -1e-6, "not between 0 and 1");
  expect(&pose->share.value, pose->share.value + 1e-9, "sum of all shares");
  expect(&pose->share.value, pose->share.value - 1e-9, "sum of all shares");
  expect(&pose->least.tilt_deg.value, -82.15, "tilt of a pose");
  expect(&pose->least.tilt_deg.value, 0, "tilt of a pose");
  expect(&pose->least.tilt_deg.value, 97.848, "tilt of a pose");
  expect(&pose->least.tilt_deg.value, NAN, "tilt of a pose");
  expect(&pose->height_m.value, 0, "centroid");
  if (pose->has_persistence) expect(&pose->persistence_m.value, -1, "persistence");
  expect(&band->least.tilt_deg.value, -1, "at which it topples");
  expect(&band->rose[1].toppling_deg.value, 180, "at which it topples");
}
END_TEST

/* A pose that is missing is one whose share is. */
START_TEST(a_missing_pose_is_refused) {
  solid->pose_count--;
  ck_assert_int_eq(tp_solid_results_check(solid, &message), TP_DEPENDENCY_FAILED);
  ck_assert_msg(strstr(message.text, "sum of all shares") != NULL, "%s", message.text);
  solid->pose_count++;
}
END_TEST

SUITE(solid_results) {
  Suite *suite = suite_create("solid_results");
  TCase *cases = tcase_create("solid_results");
  tcase_add_checked_fixture(cases, begin, end);
  tcase_add_test(cases, each_contradiction_is_refused);
  tcase_add_test(cases, a_missing_pose_is_refused);
  suite_add_tcase(suite, cases);
  return suite;
}
