/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The calls on many blocks: closed forms, columns, threads, and blocks that are none.
 *
 * One bad row among a million must not end a study, nor pass for a number: it is NaN, its status
 * says so, and the summary tells the first of them and what is wrong with it. Any number of threads
 * gives the same bytes. Random blocks are in test_random_blocks.c, verdicts in
 * test_block_verdicts.c. */

#include "drawn_blocks.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static tp_message message;

static void claim_close(tp_bounded number, double truth) {
  ck_assert_msg(fabs(number.value - truth) <= number.error + 4e-16 * fabs(truth), "%g, not %g",
                number.value, truth);
  ck_assert_double_le(number.error, 1e-13 * (1 + fabs(truth)));
}

/* b h, b h^3 / 12; and of the right-angled triangle b h / 2, b^2 h^2 / -72. */
START_TEST(moments_in_closed_form) {
  static const double slab[] = {2, 1, 2, 4, 7, 4, 7, 1, 2, 1}; /* clockwise, closed */
  static const double triangle[] = {0, 0, 3, 0, 0, 6};
  tp_area_moments m;
  ck_assert_int_eq(tp_outline_moments(&m, slab, 5, &message), TP_OK);
  claim_close(m.area, 15);
  claim_close(m.centroid_x, 4.5);
  claim_close(m.centroid_y, 2.5);
  claim_close(m.second_moment_xx, 3 * 125 / 12.);
  claim_close(m.second_moment_yy, 5 * 27 / 12.);
  claim_close(m.second_moment_xy, 0);
  ck_assert_int_eq(tp_outline_moments(&m, triangle, 3, &message), TP_OK);
  claim_close(m.area, 9);
  claim_close(m.centroid_x, 1);
  claim_close(m.second_moment_xy, -9 * 36 / 72.);
}
END_TEST

/* Areas that doubles do not tell from zero, or that no double holds, are exact. */
START_TEST(moments_that_climb) {
  static const double needle[] = {0, 0, 1, 1 + 0x1p-50, 3, 3};
  static const double huge[] = {0, 0, 1e200, 0, 0, 1e200};
  tp_area_moments m;
  ck_assert_int_eq(tp_outline_moments(&m, needle, 3, &message), TP_OK);
  ck_assert_double_eq(m.area.value, 0x3p-51);
  ck_assert_double_eq(m.area.error, 0);
  ck_assert_int_eq(tp_outline_moments(&m, huge, 3, &message), TP_OK);
  ck_assert(isinf(m.area.error));
  ck_assert_double_eq(m.centroid_x.value, 1e200 / 3);
}
END_TEST

START_TEST(outlines_without_moments) {
  static const double line[] = {0, 0, 1, 1, 2, 2}, eight[] = {0, 0, 2, 2, 2, 0, 0, 2};
  static const double bad[] = {0, 0, 1, NAN, 1, 1}, far[] = {0, 0, 1, 0, 1, INFINITY};
  static const struct {
    const double *xy;
    size_t count;
    const char *says;
  } cases[] = {{line, 3, "area of zero"},       {eight, 4, "area of zero"},
               {line, 2, "has 2 vertices"},     {line, 0, "has 0 vertices"},
               {bad, 3, "y of point 2 of the"}, {far, 3, "not inf"}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_area_moments m = {.area = {.value = 7}};
    ck_assert_int_eq(tp_outline_moments(&m, cases[k].xy, cases[k].count, &message), TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, cases[k].says) != NULL, "%s", message.text);
    ck_assert_double_eq(m.area.value, 7);
  }
}
END_TEST

/* Slabs b by h topple at atan(b / h), about either end. */
START_TEST(slabs) {
  static const double xy[] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 2, 0, 2};
  const tp_outlines outlines = tp_outlines_of(xy, 2, 4);
  tp_blocks_options options = tp_blocks_options_default();
  double angle[2], error[2];
  long pivot[2];
  tp_blocks_summary summary;
  const tp_critical_columns columns = {.angle_deg = angle, .error_deg = error, .pivot = pivot};
  for (int right = 0; right < 2; right++) {
    options.towards = right ? TP_TOWARDS_RIGHT : TP_TOWARDS_LEFT;
    ck_assert_int_eq(tp_blocks_critical_angles(&columns, &summary, &outlines, &options, &message),
                     TP_OK);
    claim_close((tp_bounded){angle[0], error[0], NULL}, 45);
    claim_close((tp_bounded){angle[1], error[1], NULL}, 26.565051177077989);
    ck_assert_int_eq(pivot[0], right);
    ck_assert_uint_eq(summary.done, 2);
    ck_assert_uint_eq(summary.climbed, 0);
  }
}
END_TEST

typedef struct critical {
  double angle[BLOCKS], error[BLOCKS];
  long pivot[BLOCKS];
  tp_status status[BLOCKS];
  tp_blocks_summary summary;
} critical;

static void find(critical *c, const tp_outlines *outlines, size_t threads) {
  tp_blocks_options options = tp_blocks_options_default();
  options.threads = threads;
  memset(c, 0, sizeof *c);
  const tp_critical_columns columns = {c->angle, c->error, c->pivot, c->status};
  ck_assert_int_eq(tp_blocks_critical_angles(&columns, &c->summary, outlines, &options, &message),
                   TP_OK);
}

START_TEST(bad_blocks_stop_nothing) {
  static critical c;
  const tp_outlines outlines = draw_blocks();
  find(&c, &outlines, 1);
  size_t counts[TP_UNDECIDED + 1] = {0};
  for (size_t k = 0; k < BLOCKS; k++) {
    ck_assert_int_le(c.status[k], TP_UNDECIDED);
    counts[c.status[k]]++;
    ck_assert_int_eq(c.status[k] == TP_OK, !isnan(c.angle[k]));
    ck_assert_int_eq(c.status[k] == TP_OK, c.pivot[k] >= 0);
    if (k % BAD_EVERY == BAD_EVERY - 1) ck_assert_int_eq(c.status[k], TP_BAD_INPUT);
  }
  ck_assert_uint_eq(c.summary.done, counts[TP_OK]);
  ck_assert_uint_eq(c.summary.without, counts[TP_NO_ANSWER]);
  ck_assert_uint_eq(c.summary.bad, counts[TP_BAD_INPUT]);
  ck_assert_uint_eq(c.summary.undecided, 0);
  size_t first = 0;
  while (c.status[first] != TP_BAD_INPUT) first++;
  ck_assert_uint_eq(c.summary.first_bad, first);
  char says[32];
  snprintf(says, sizeof says, "block %zu: ", first);
  ck_assert_msg(strncmp(c.summary.complaint.text, says, strlen(says)) == 0, "%s",
                c.summary.complaint.text);
}
END_TEST

START_TEST(any_number_of_threads) {
  static const size_t threads[] = {2, 7, 0};
  static critical first, other;
  const tp_outlines outlines = draw_blocks();
  find(&first, &outlines, 1);
  for (size_t k = 0; k < sizeof threads / sizeof threads[0]; k++) {
    find(&other, &outlines, threads[k]);
    ck_assert(same_bytes(&first, &other, sizeof first));
  }
}
END_TEST

/* Columns that are not wanted, and no blocks at all. */
START_TEST(no_columns) {
  const tp_outlines outlines = draw_blocks(), none = tp_outlines_of(NULL, 0, 4);
  const tp_blocks_options options = tp_blocks_options_default();
  const tp_critical_columns no_angles = {0};
  const tp_moment_columns no_moments = {0};
  const tp_verdict_columns no_verdicts = {0};
  tp_blocks_summary summary, other;
  ck_assert_int_eq(tp_blocks_critical_angles(&no_angles, &summary, &outlines, &options, &message),
                   TP_OK);
  ck_assert_int_eq(tp_outlines_moments(&no_moments, &other, &outlines, &options, &message), TP_OK);
  ck_assert_uint_le(other.bad, summary.bad); /* outlines that meet themselves have moments */
  ck_assert_uint_gt(other.bad, 0);
  ck_assert_int_eq(tp_blocks_solve(&no_verdicts, &summary, &none, tp_numbers_of(NAN),
                                   tp_numbers_of(NAN), &options, &message),
                   TP_OK);
  ck_assert_uint_eq(summary.done + summary.bad + summary.undecided + summary.without, 0);
}
END_TEST

START_TEST(moments_of_many) {
  static double area[BLOCKS], area_error[BLOCKS], xy[BLOCKS], xy_error[BLOCKS];
  static tp_status status[BLOCKS];
  const tp_outlines outlines = draw_blocks();
  const tp_blocks_options options = tp_blocks_options_default();
  const tp_moment_columns columns = {.area = area,
                                     .area_error = area_error,
                                     .second_moment_xy = xy,
                                     .second_moment_xy_error = xy_error,
                                     .status = status};
  tp_blocks_summary summary;
  ck_assert_int_eq(tp_outlines_moments(&columns, &summary, &outlines, &options, &message), TP_OK);
  for (size_t k = 0; k < BLOCKS; k++) {
    tp_area_moments one;
    const double *own = all_xy + 2 * first_of[k];
    const tp_status alone = tp_outline_moments(&one, own, first_of[k + 1] - first_of[k], &message);
    ck_assert_int_eq(alone, status[k]);
    ck_assert_int_eq(alone != TP_OK, isnan(area[k]));
    if (alone != TP_OK) continue;
    ck_assert_double_eq(one.area.value, area[k]);
    ck_assert_double_eq(one.area.error, area_error[k]);
    ck_assert_double_eq(one.second_moment_xy.value, xy[k]);
    ck_assert_double_eq(one.second_moment_xy.error, xy_error[k]);
  }
}
END_TEST

SUITE(blocks) {
  Suite *suite = suite_create("blocks");
  TCase *tests = tcase_create("blocks");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, moments_in_closed_form);
  tcase_add_test(tests, moments_that_climb);
  tcase_add_test(tests, outlines_without_moments);
  tcase_add_test(tests, slabs);
  tcase_add_test(tests, bad_blocks_stop_nothing);
  tcase_add_test(tests, any_number_of_threads);
  tcase_add_test(tests, no_columns);
  tcase_add_test(tests, moments_of_many);
  suite_add_tcase(suite, tests);
  return suite;
}
