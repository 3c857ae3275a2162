/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report_stage.h"

#include "suite.h"

#include <stdlib.h>
#include <string.h>

tp_bounded number(double value) {
  return (tp_bounded){.value = value, .error = 1e-12};
}

tp_solution filled(void) {
  static tp_case cases[2]; /* of the solution that was filled last */
  memset(cases, 0, sizeof cases);
  tp_solution s = {.size = sizeof s,
                   .case_size = sizeof cases[0],
                   .cases = cases,
                   .length_unit = "m",
                   .metres_per_unit = 1,
                   .has_tilt_angle = true};
  s.tilt_angle_deg = (tp_bounded){.value = 20};
  s.has_friction = true;
  s.friction_angle_deg = (tp_bounded){.value = 40};
  s.block.area_m2 = number(1);
  s.block.vertices = 4;
  s.contact = (tp_contact_result){.facets = 1};
  s.digits = 9;
  s.case_count = 1;
  tp_case *c = s.cases;
  c->limit = (tp_limit){.kind = TP_LIMIT_AT_ANGLE, .mechanism = TP_SLIDES};
  c->limit.critical_angle_deg = number(40);
  c->mechanism = TP_STANDS;
  c->first = TP_SLIDES;
  c->has_first_angle = c->has_margin = c->has_margin_to_first = true;
  c->first_angle_deg = number(40);
  c->margin_deg = c->margin_to_first_deg = number(20);
  c->governing_fos.fos.state = TP_FOS_NUMBER;
  c->governing_fos.fos.value = number(2);
  c->governing_fos.at_least = 2 - c->governing_fos.fos.value.error;
  c->governing_fos.at_most = 2 + c->governing_fos.fos.value.error;
  c->governing_fos.sliding_judged = c->governing_fos.complete = true;
  return s;
}

/* Characters of the longest line. */
static size_t longest_line(const char *text) {
  size_t longest = 0, length = 0;
  for (; *text != '\0'; text++) {
    length = *text == '\n' ? 0 : length + (((unsigned char)*text & 0xc0) != 0x80);
    if (length > longest) longest = length;
  }
  return longest;
}

void says(const tp_solution *s, const char *words, const char *others) {
  char *text = NULL;
  ck_assert_int_eq(tp_report_text(&text, s), TP_OK);
  ck_assert_msg(strstr(text, words) != NULL, "'%s' is not in\n%s", words, text);
  ck_assert_msg(others == NULL || strstr(text, others) == NULL, "'%s' is in\n%s", others, text);
  ck_assert_uint_le(longest_line(text), 80);
  free(text);
}

void json_has(const tp_solution *s, const char *members) {
  char *text = NULL;
  ck_assert_int_eq(tp_report_json(&text, s), TP_OK);
  ck_assert_msg(strstr(text, members) != NULL, "'%s' is not in\n%s", members, text);
  free(text);
}
