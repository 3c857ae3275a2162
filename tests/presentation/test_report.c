/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reports of solutions that are filled in by hand: kinds of onset that scenes come to rarely, every
 * line fits a terminal, and none says that a block stands where a motion can begin. JSON of them is
 * in test_report_json.c. */

#include "report_stage.h"
#include "suite.h"

#include "topple.h"

#include <stdlib.h>
#include <string.h>

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
  says(&s, "May move at 20° or stand: the result depends on loading history.\n", "Stands at");
  o->beginning_count = 2;
  o->beginnings[0] = TP_SLIDES;
  o->beginnings[1] = TP_TOPPLES;
  o->tie = true;
  o->tied_with = TP_LEAVES_BASE;
  says(&s, "toppling is possible,\n  or leaving its base, a tie, exactly.\n", NULL);
  o->tie_bits = 640;
  says(&s, "or leaving its base, a tie,\n  as far as 640 bits can distinguish.\n", "exactly");
  says(&s,
       "May move at 20° or stand: the result depends on loading history.\n  It can begin to slide, "
       "or to topple.\n",
       "Stands at");
}
END_TEST

START_TEST(onset_that_is_open) {
  tp_solution s = filled();
  tp_onset *o = &s.cases[0].onset;
  *o = (tp_onset){.kind = TP_ONSET_UNDECIDED, .too_dear = true};
  s.cases[0].mechanism = TP_MECHANISM_UNDECIDED;
  says(&s, "Whether it stands at 20° is undecided.", "Stands at");
  says(&s,
       "The tilt up to which it is certain to stand is undecided: its proof\n  exceeds the work",
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
  says(&s, "Not certain to stand at any tilt.\n  From that tilt sliding is possible.\n",
       "Stands at");
  says(&s, "Beyond that tilt the result depends on loading history", NULL);
  *o = (tp_onset){.kind = TP_ONSET_AT_ANGLE, .mechanism = TP_SLIDES, .below_limit = true};
  o->critical_angle_deg = number(-3);
  says(&s, "Not certain to stand even on level ground, only below -3.000°.\n", "Stands at");
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
  s.cases[0].governing_fos.at_least = 0;
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
  s.cases[1].governing_fos.at_least = 0;
  ck_assert_int_eq(tp_solution_meets(&s, 1.9), TP_DESIGN_OPEN);
  s.cases[1].governing_fos.fos.state = TP_FOS_UNDEFINED;
  s.cases[1].governing_fos.at_most = 0;
  ck_assert_int_eq(tp_solution_meets(&s, 1.9), TP_DESIGN_NOT_MET);
}
END_TEST

/* Notes break at words, below each other. */
START_TEST(notes) {
  tp_solution s = filled();
  char place[] = "a scene.yaml:4:3", text[512] = "";
  tp_note own = {TP_CAUTION, place, text};
  for (int k = 0; k < 40; k++) strcat(text, k % 3 == 0 ? "Böschung " : "in words ");
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
                        "    \"intervals\": [],\n"
                        "    \"at_least\": []}\n"
                        "}\n");
  free(text);
}
END_TEST

SUITE(report) {
  Suite *suite = suite_create("report");
  TCase *cases = tcase_create("report");
  tcase_add_test(cases, windows);
  tcase_add_test(cases, onset_that_is_open);
  tcase_add_test(cases, onset_at_the_ends);
  tcase_add_test(cases, motions);
  tcase_add_test(cases, design_factors);
  tcase_add_test(cases, notes);
  tcase_add_test(cases, what_was_found);
  suite_add_tcase(suite, cases);
  return suite;
}
