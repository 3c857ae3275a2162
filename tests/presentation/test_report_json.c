/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JSON of solutions that are filled in by hand: what stands where there is no number, which pivots
 * are listed, and titles from outside, on the page and in tables too. */

#include "report_stage.h"
#include "suite.h"

#include <stdlib.h>
#include <string.h>

START_TEST(json_of_what_is_no_number) {
  tp_solution s = filled();
  tp_case *c = s.cases;
  json_has(&s, "      \"toppling\": null,\n");
  json_has(&s, "      \"can_begin\": null,\n");
  json_has(&s, "        \"weight_n\": null,\n        \"vertices\": 4, \"holes\": 0, ");
  json_has(&s, "      \"pivots\": [\n      ],\n");
  json_has(&s, "      \"factors\": [],\n");
  c->governing_fos.up_dip = true;
  json_has(&s, "{\"fos\": null, \"fos_is\": \"none: at this tilt it fails up-dip\", ");
  c->sliding = (tp_sliding){.known = true, .never = true};
  json_has(&s, "\"critical_angle_is\": \"never\", \"fos\": null, \"fos_is\": \"unbounded: ");
  c->sliding = (tp_sliding){.known = true, .always = true};
  json_has(&s, "\"critical_angle_deg\": null, \"critical_angle_is\": \"always\", \"fos\": {");
  c->limit_holds_from.kind = TP_LIMIT_NOWHERE;
  json_has(&s, "\"holds_from_deg\": null, \"holds_from_is\": \"at no tilt\", ");
  c->limit.tie = true;
  c->limit.tied_with = TP_TOPPLES;
  json_has(&s,
           "\"tied_with\": \"topples\", \"tie_is\": \"exact\",\n        \"centre_x_m\": null, ");
  c->limit.tie_bits = 160;
  json_has(&s, "\"tie_is\": \"not distinguished by 160 bits\",\n");
}
END_TEST

/* A factor below zero is the governing pivot's alone. */
START_TEST(json_of_pivots) {
  tp_solution s = filled();
  tp_pivot own[2] = {{.kind = TP_PIVOT_PEAK, .computed = true, .never = true},
                     {.index = 1, .kind = TP_PIVOT_VALLEY, .computed = true}};
  for (int k = 0; k < 2; k++) {
    own[k].fos = (tp_fos){.state = TP_FOS_NUMBER, .value = {.value = -2}};
    own[k].fos_elements = (tp_fos){.state = TP_FOS_UNDEFINED};
  }
  own[1].admissible = true;
  s.cases[0].candidate_count = s.cases[0].pivot_count = 2;
  s.cases[0].pivots = own;
  json_has(&s, "\"pivot_count\": 2, \"pivots_listed\": \"all\",\n      \"pivots\": [\n        {");
  json_has(&s, "{\"index\": 0, \"kind\": \"peak\", ");
  json_has(&s, "\"critical_angle_deg\": null, \"critical_angle_is\": \"never\", \"fos\": null, "
               "\"fos_is\": \"none: resisting action is negative\", \"fos_elements\": null, "
               "\"fos_elements_is\": \"none: no strength holds it\", \"admissible\": false},\n");
  json_has(&s, "\"fos\": {\"value\": -2, \"error\": 0}, \"fos_is\": \"none: resisting action is "
               "negative\", ");
}
END_TEST

/* In each language by its own rules. */
START_TEST(titles_from_outside) {
  tp_solution s = filled();
  const tp_solution *all[] = {&s};
  char title[] = "=A \"block\",\n| <b>\x1b[1m", *text = NULL;
  s.title = title;
  json_has(&s, "  \"title\": \"=A \\\"block\\\",\\u000a| <b>\\u001b[1m\",\n");
  says(&s, "=A \"block\", | <b>\\x1B[1m\n", NULL);
  ck_assert_int_eq(tp_report_table(&text, all, 1), TP_OK);
  ck_assert_ptr_nonnull(strstr(text, "\n| \\=A \"block\", \\| &lt;b&gt;"));
  free(text);
  ck_assert_int_eq(tp_report_csv(&text, all, 1), TP_OK);
  ck_assert_ptr_nonnull(strstr(text, "\n\"'=A \"\"block\"\", | <b>\\x1B[1m\",left,20,0,stands,"));
  free(text);
}
END_TEST

SUITE(report_json) {
  Suite *suite = suite_create("report_json");
  TCase *tests = tcase_create("json");
  tcase_add_test(tests, json_of_what_is_no_number);
  tcase_add_test(tests, json_of_pivots);
  tcase_add_test(tests, titles_from_outside);
  suite_add_tcase(suite, tests);
  return suite;
}
