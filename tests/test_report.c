/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reports of solutions that are filled in by hand. The page: kinds of onset that scenes come to
 * rarely, every line fits a terminal, and none says that a block stands where a motion can begin.
 * JSON and tables: what stands where there is no number, and text from outside. */

#include "runner.h"

#include "topple.h"

#include <stdlib.h>
#include <string.h>

static tp_bounded number(double value) {
  return (tp_bounded){.value = value, .error = 1e-12};
}

/* A square on friction, tilted to the left by 20 degrees, with a limit of 40. */
static tp_solution filled(void) {
  tp_solution s = {.length_unit = "m", .metres_per_unit = 1, .has_tilt_angle = true};
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

/* The report has the words, and not those others. */
static void says(const tp_solution *s, const char *words, const char *others) {
  char *text = NULL;
  ck_assert_int_eq(tp_report_text(&text, s), TP_OK);
  ck_assert_msg(strstr(text, words) != NULL, "'%s' is not in\n%s", words, text);
  ck_assert_msg(others == NULL || strstr(text, others) == NULL, "'%s' is in\n%s", others, text);
  ck_assert_uint_le(longest_line(text), 80);
  free(text);
}

START_TEST(windows) {
  tp_solution s = filled();
  tp_window own[3] = {{.from_below = true, .to_deg = number(-10), .begins = TP_SLIDES},
                      {.from_deg = number(15), .to_deg = number(18), .begins = TP_TOPPLES},
                      {.from_deg = number(35), .to_above = true, .begins = TP_SLIDES}};
  tp_onset *o = &s.cases[0].onset;
  *o = (tp_onset){.kind = TP_ONSET_AT_ANGLE, .mechanism = TP_TOPPLES, .below_limit = true};
  o->critical_angle_deg = number(15);
  o->window_count = 3;
  o->windows = own;
  says(&s, "Stands at 20°.\n  Certain to stand up to α_s = 15.000°.\n", "margin");
  says(
      &s,
      "Motions can begin from 15.000° to 18.000° (first to topple),\n    from 35.000° on (first to "
      "slide)\n  and at no other tilt up to 90°.\n",
      "-10");
  s.cases[0].mechanism = TP_MAY_MOVE;
  says(&s, "May move at 20°, or stand: history decides.\n", "Stands at");
  o->beginning_count = 2;
  o->beginnings[0] = TP_SLIDES;
  o->beginnings[1] = TP_TOPPLES;
  o->tie = true;
  o->tied_with = TP_LEAVES_BASE;
  says(&s, "begin to topple,\n  or to leave its base, a tie, exactly.\n", NULL);
  o->tie_bits = 640;
  says(&s, "or to leave its base, a tie,\n  as far as 640 bits tell.\n", "exactly");
  says(&s, "May move at 20°, or stand: history decides.\n  It can begin to slide, or to topple.\n",
       "Stands at");
  says(&s, "Caution: a motion can begin at this tilt all the same", NULL);
}
END_TEST

START_TEST(onset_that_is_open) {
  tp_solution s = filled();
  tp_onset *o = &s.cases[0].onset;
  *o = (tp_onset){.kind = TP_ONSET_UNDECIDED, .too_dear = true};
  s.cases[0].mechanism = TP_MECHANISM_UNDECIDED;
  says(&s, "Whether it stands at 20° is undecided.", "Stands at");
  says(&s, "Up to which tilt it is certain to stand is undecided: its proof takes\n  more work",
       NULL);
  ck_assert_int_eq(tp_solution_meets(&s, 1), TP_DESIGN_OPEN);
  ck_assert_int_eq(tp_solution_meets(&s, 3), TP_DESIGN_NOT_MET);
}
END_TEST

START_TEST(onset_at_the_ends) {
  tp_solution s = filled();
  tp_onset *o = &s.cases[0].onset;
  *o = (tp_onset){.kind = TP_ONSET_NEVER};
  s.cases[0].limit.kind = TP_LIMIT_INTERLOCKED;
  says(&s, "Certain to stand at every tilt up to 90°: no motion can begin.\n", "history");
  *o = (tp_onset){.kind = TP_ONSET_NOWHERE, .mechanism = TP_SLIDES};
  s.cases[0].mechanism = TP_MAY_MOVE;
  says(&s, "Not certain to stand at any tilt.\n  From there it can begin to slide.\n", "Stands at");
  says(&s, "Beyond that history decides", NULL);
  *o = (tp_onset){.kind = TP_ONSET_AT_ANGLE, .mechanism = TP_SLIDES, .below_limit = true};
  o->critical_angle_deg = number(-3);
  says(&s, "Not certain to stand even on level ground, but only below -3.000°.\n", "Stands at");
}
END_TEST

START_TEST(motions) {
  tp_solution s = filled();
  tp_motion_contact contact = {
      .of_facet = true, .facet = 2, .state = TP_CONTACT_SLIPS_DOWN_DIP, .has_force = true};
  contact.share_x = contact.share_y = number(0.5);
  tp_motion own[2] = {{.mechanism = TP_SLIDES, .contact_count = 1, .contacts = &contact},
                      {.mechanism = TP_LEAVES_BASE, .accelerations_fixed = true}};
  tp_onset *o = &s.cases[0].onset;
  *o =
      (tp_onset){.kind = TP_ONSET_AT_ANGLE, .has_motions = true, .motion_count = 2, .motions = own};
  o->critical_angle_deg = number(15);
  o->beginning_count = 2;
  o->beginnings[0] = TP_SLIDES;
  o->beginnings[1] = TP_LEAVES_BASE;
  o->paradox = true;
  s.cases[0].mechanism = TP_SLIDES;
  says(&s, "Does not stand at 20°: it can begin to slide, or to leave its base.\n", "Stands at");
  says(&s,
       "    slides:\n      at least x 0 g, y 0 g, turning 0 g/m\n      facet 3, left end: slips "
       "down-dip, force (0.5, 0.5) W\n",
       NULL);
  says(&s, "every contact opens\n", "overcomes");
  own[0].has_strength = own[0].greatest = true;
  own[0].cohesion.share_x = number(0.25);
  own[0].bond.share_y = number(-0.125);
  says(&s,
       "at most x 0 g, y 0 g, turning 0 g/m\n      overcomes cohesion (0.2500, 0.0000) W and bonds "
       "(0.0000, "
       "-0.1250) W\n",
       "at least");
  says(&s, "Painlevé's paradox", NULL);
}
END_TEST

START_TEST(design_factors) {
  tp_solution s = filled();
  ck_assert_int_eq(tp_solution_meets(&s, 1.9), TP_DESIGN_MET);
  ck_assert_int_eq(tp_solution_meets(&s, 2.1), TP_DESIGN_NOT_MET);
  ck_assert_int_eq(tp_solution_meets(&s, 2), TP_DESIGN_OPEN); /* within the bound */
  s.cases[0].governing_fos.complete = false;
  ck_assert_int_eq(tp_solution_meets(&s, 1.9), TP_DESIGN_OPEN);
  ck_assert_int_eq(tp_solution_meets(&s, 2.1), TP_DESIGN_NOT_MET);
  says(&s, "FoS at most 2.000", NULL);
  s = filled();
  s.cases[0].mechanism = TP_MAY_MOVE;
  ck_assert_int_eq(tp_solution_meets(&s, 1), TP_DESIGN_NOT_MET);
  s = filled();
  s.cases[1] = s.cases[0]; /* the worse of two directions tells */
  s.case_count = 2;
  s.cases[1].governing_fos.fos.state = TP_FOS_UNDECIDED;
  ck_assert_int_eq(tp_solution_meets(&s, 1.9), TP_DESIGN_OPEN);
  s.cases[1].governing_fos.fos.state = TP_FOS_UNDEFINED;
  ck_assert_int_eq(tp_solution_meets(&s, 1.9), TP_DESIGN_NOT_MET);
}
END_TEST

/* The JSON has the members, in a row. */
static void json_has(const tp_solution *s, const char *members) {
  char *text = NULL;
  ck_assert_int_eq(tp_report_json(&text, s), TP_OK);
  ck_assert_msg(strstr(text, members) != NULL, "'%s' is not in\n%s", members, text);
  free(text);
}

START_TEST(json_of_what_is_no_number) {
  tp_solution s = filled();
  tp_case *c = s.cases;
  json_has(&s, "      \"toppling\": null,\n");
  json_has(&s, "      \"can_begin\": null,\n");
  json_has(&s, "        \"weight_n\": null,\n        \"vertices\": 4, \"holes\": 0, ");
  json_has(&s, "      \"pivots\": [\n      ],\n");
  json_has(&s, "      \"factors\": [],\n");
  c->governing_fos.up_dip = true;
  json_has(&s, "{\"fos\": null, \"fos_is\": \"none: at this tilt it lets go up-dip\", ");
  c->sliding = (tp_sliding){.known = true, .never = true};
  json_has(&s, "\"critical_angle_is\": \"never\", \"fos\": null, \"fos_is\": \"unbounded: ");
  c->sliding = (tp_sliding){.known = true, .always = true};
  json_has(&s, "\"critical_angle_deg\": null, \"critical_angle_is\": \"always\", \"fos\": {");
  c->limit_back.kind = TP_LIMIT_NOWHERE;
  json_has(&s, "\"holds_from_deg\": null, \"holds_from_is\": \"at no tilt\", ");
  c->limit.tie = true;
  c->limit.tied_with = TP_TOPPLES;
  json_has(&s,
           "\"tied_with\": \"topples\", \"tie_is\": \"exact\",\n        \"centre_x_m\": null, ");
  c->limit.tie_bits = 160;
  json_has(&s, "\"tie_is\": \"not told apart by 160 bits\",\n");
}
END_TEST

/* A factor below zero is the governing pivot's alone. */
START_TEST(json_of_pivots) {
  tp_solution s = filled();
  tp_pivot own[2] = {{.kind = TP_PIVOT_PEAK, .never = true}, {.kind = TP_PIVOT_VALLEY}};
  for (int k = 0; k < 2; k++) {
    own[k].fos_resultant = (tp_fos){.state = TP_FOS_NUMBER, .value = {.value = -2}};
    own[k].fos_elements = (tp_fos){.state = TP_FOS_UNDEFINED};
  }
  own[1].admissible = true;
  s.cases[0].pivot_count = 2;
  s.cases[0].pivots = own;
  json_has(&s, "\"pivot_count\": 2, \"pivots_listed\": \"all\",\n      \"pivots\": [\n        {");
  json_has(&s, "{\"index\": 0, \"kind\": \"peak\", ");
  json_has(&s,
           "\"critical_angle_deg\": null, \"critical_angle_is\": \"never\", \"fos\": null, "
           "\"fos_is\": \"none: what should hold it drives it\", \"fos_elements\": null, "
           "\"fos_elements_is\": \"none: no strength would hold it\", \"admissible\": false},\n");
  json_has(&s, "\"fos\": {\"value\": -2, \"error\": 0}, \"fos_is\": \"none: what should hold it "
               "drives it\", ");
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

/* Notes break at words, below each other. */
START_TEST(notes) {
  tp_solution s = filled();
  tp_note own = {.kind = TP_CAUTION, .place = "a scene.yaml:4:3"};
  for (int k = 0; k < 40; k++) strcat(own.text, k % 3 == 0 ? "Böschung " : "in words ");
  s.notes = (tp_notes){.count = 1, .items = &own};
  says(&s, "\nCaution  Böschung in words in words", NULL);
  says(&s, "\n         ", NULL);
  says(&s, "scene.yaml:4:3)\n", NULL);
  json_has(&s, "  \"notes\": [\n    {\"kind\": \"caution\", \"place\": \"a scene.yaml:4:3\", ");
}
END_TEST

START_TEST(what_was_found) {
  tp_solution s = filled();
  char key[] = "block.\"x\"", *text = NULL;
  tp_bounded solutions[2] = {{.value = 1.5, .error = 0.25}, {.value = 2}};
  const tp_found found = {.key = key, .high = 3, .count = 2, .solutions = solutions};
  ck_assert_int_eq(tp_report_found_json(&text, &found, &s), TP_OK);
  const char *end = strstr(text, ",\n  \"find\": ");
  ck_assert_ptr_nonnull(end);
  ck_assert_str_eq(end, ",\n  \"find\": {\"key\": \"block.\\\"x\\\"\", \"from\": 0, \"to\": 3,\n"
                        "    \"least\": {\"value\": 0, \"error\": 0}, "
                        "\"greatest\": {\"value\": 0, \"error\": 0},\n"
                        "    \"solutions\": [{\"value\": 1.5, \"error\": 0.25}, "
                        "{\"value\": 2, \"error\": 0}],\n"
                        "    \"touching\": [],\n"
                        "    \"intervals\": []}\n"
                        "}\n");
  free(text);
}
END_TEST

int main(void) {
  Suite *suite = suite_create("report");
  TCase *cases = tcase_create("report");
  tcase_add_test(cases, windows);
  tcase_add_test(cases, onset_that_is_open);
  tcase_add_test(cases, onset_at_the_ends);
  tcase_add_test(cases, motions);
  tcase_add_test(cases, design_factors);
  tcase_add_test(cases, json_of_what_is_no_number);
  tcase_add_test(cases, json_of_pivots);
  tcase_add_test(cases, titles_from_outside);
  tcase_add_test(cases, notes);
  tcase_add_test(cases, what_was_found);
  suite_add_tcase(suite, cases);
  return run_suite(suite);
}
