/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments that no call on many blocks can do anything with, as in test_arguments.c; columns are
 * left alone. */

#include "refused.h"

#include <math.h>

START_TEST(blocks) {
  static const double xy[] = {0, 0, 1, 0, 1, 1, 0, 1};
  static const size_t falls[] = {0, 4, 3};
  double number = 7;
  tp_area_moments *moments = UNTOUCHED(tp_area_moments);
  tp_blocks_summary *told = UNTOUCHED(tp_blocks_summary);
  const tp_blocks_options good = tp_blocks_options_default();
  const tp_outlines one = tp_outlines_of(xy, 1, 4);
  const tp_numbers none = tp_numbers_of(NAN);
  const tp_moment_columns area = {.area = &number};
  const tp_critical_columns angle = {.angle_deg = &number};
  const tp_verdict_columns fos = {.fos = &number};
  REFUSED(tp_outline_moments(NULL, xy, 4, &message), "'moments'");
  REFUSED(tp_outline_moments(moments, NULL, 4, &message), "'xy'");
  REFUSED(tp_outlines_moments(NULL, told, &one, &good, &message), "'columns'");
  REFUSED(tp_outlines_moments(&area, NULL, &one, &good, &message), "'summary'");
  REFUSED(tp_outlines_moments(&area, told, NULL, &good, &message), "'outlines'");
  REFUSED(tp_outlines_moments(&area, told, &one, NULL, &message), "'options'");
  REFUSED(tp_blocks_critical_angles(NULL, told, &one, &good, &message), "'columns'");
  REFUSED(tp_blocks_critical_angles(&angle, NULL, &one, &good, &message), "'summary'");
  REFUSED(tp_blocks_critical_angles(&angle, told, NULL, &good, &message), "'outlines'");
  REFUSED(tp_blocks_critical_angles(&angle, told, &one, NULL, &message), "'options'");
  REFUSED(tp_blocks_solve(NULL, told, &one, none, none, &good, &message), "'columns'");
  REFUSED(tp_blocks_solve(&fos, NULL, &one, none, none, &good, &message), "'summary'");
  REFUSED(tp_blocks_solve(&fos, told, NULL, none, none, &good, &message), "'outlines'");
  REFUSED(tp_blocks_solve(&fos, told, &one, none, none, NULL, &message), "'options'");
  tp_blocks_options bad = good;
  tp_blocks_options_init(NULL, sizeof bad);
  bad.size = 0;
  REFUSED(tp_blocks_critical_angles(&angle, told, &one, &bad, &message), "size of 'options'");
  bad = good;
  bad.towards = (tp_direction)2;
  REFUSED(tp_blocks_critical_angles(&angle, told, &one, &bad, &message), "'towards'");
  const tp_outlines nowhere = tp_outlines_of(NULL, 1, 4), back = tp_outlines_ragged(xy, 2, falls);
  const tp_outlines vast = tp_outlines_of(xy, 1, SIZE_MAX / 2);
  REFUSED(tp_outlines_moments(&area, told, &nowhere, &good, &message), "must not be NULL");
  REFUSED(tp_blocks_solve(&fos, told, &back, none, tp_numbers_each(NULL), &good, &message),
          "must not fall");
  REFUSED(tp_outlines_moments(&area, told, &vast, &good, &message), "too many");
  ck_assert_int_eq(tp_outlines_moments(&area, told, &nowhere, &good, NULL), TP_BAD_INPUT);
  ck_assert_double_eq(number, 7);
}
END_TEST

SUITE(block_arguments) {
  Suite *suite = suite_create("block_arguments");
  TCase *tests = tcase_create("arguments");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, blocks);
  suite_add_tcase(suite, tests);
  return suite;
}
