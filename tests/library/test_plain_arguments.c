/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments that no call can do anything with, of calls that have no status to say so (those of all
 * others are in tests/library/test_arguments.c): they answer something, and write nowhere. */

#include "suite.h"

#include "topple.h"

/* Values outside of their enumeration have a name, too. */
START_TEST(names) {
  static const int values[] = {-1, 1000, 2147483647, -2147483647 - 1};
  for (size_t k = 0; k < sizeof values / sizeof values[0]; k++) {
    const int v = values[k];
    ck_assert_str_eq(tp_status_meaning((tp_status)v), "unknown status");
    ck_assert_str_eq(tp_fault_name((tp_fault)v), "unknown");
    ck_assert_int_eq(tp_status_exit((tp_status)v), tp_status_exit(TP_SYSTEM_FAILED));
    ck_assert_ptr_nonnull(tp_fos_definition_name((tp_fos_definition)v));
    ck_assert_ptr_nonnull(tp_factor_standing_name((tp_factor_standing)v));
    ck_assert_ptr_nonnull(tp_note_kind_name((tp_note_kind)v));
    ck_assert_ptr_nonnull(tp_mechanism_name((tp_mechanism)v));
    ck_assert_ptr_nonnull(tp_solid_outlook_name((tp_solid_outlook)v));
    ck_assert_ptr_nonnull(tp_settling_end_name((tp_settling_end)v));
  }
  ck_assert_str_eq(tp_version(), TP_VERSION);
  ck_assert_int_eq(tp_version_number(), TP_VERSION_NUMBER);
  ck_assert_str_eq(tp_figure_version(), TP_VERSION);
  tp_text_free(NULL);
  tp_cleanup();
  ck_assert_ptr_nonnull(tp_sheet_languages());
  char plain[] = "untouched", empty[1] = "x";
  tp_plain_text(NULL, 9, "text");
  tp_plain_text(plain, 0, "text");
  ck_assert_str_eq(plain, "untouched");
  for (size_t size = 1; size < 4; size++) {
    tp_plain_text(size == 1 ? empty : plain, size, "text");
    ck_assert_str_eq(size == 1 ? empty : plain, "");
  }
  tp_plain_text(plain, sizeof plain, NULL);
  ck_assert_str_eq(plain, "");
}
END_TEST

/* No options, and no room for their size. */
START_TEST(no_options) {
  _Alignas(size_t) char room[8] = "untold";
  for (size_t size = 0; size < sizeof(size_t); size++) {
    tp_solve_options_init((tp_solve_options *)(void *)room, size);
    tp_derive_options_init((tp_derive_options *)(void *)room, size);
    tp_find_options_init((tp_find_options *)(void *)room, size);
    tp_chart_fos_options_init((tp_chart_fos_options *)(void *)room, size);
    tp_chart_mechanisms_options_init((tp_chart_mechanisms_options *)(void *)room, size);
    tp_chart_map_options_init((tp_chart_map_options *)(void *)room, size);
  }
  ck_assert_str_eq(room, "untold");
  tp_solve_options_init(NULL, sizeof(tp_solve_options));
  tp_derive_options_init(NULL, sizeof(tp_derive_options));
  tp_find_options_init(NULL, sizeof(tp_find_options));
  tp_chart_fos_options_init(NULL, sizeof(tp_chart_fos_options));
  tp_chart_mechanisms_options_init(NULL, sizeof(tp_chart_mechanisms_options));
  tp_chart_map_options_init(NULL, sizeof(tp_chart_map_options));
}
END_TEST

SUITE(plain_arguments) {
  Suite *suite = suite_create("plain_arguments");
  TCase *tests = tcase_create("arguments");
  tcase_add_test(tests, names);
  tcase_add_test(tests, no_options);
  suite_add_tcase(suite, tests);
  return suite;
}
