/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of solids that no call can do anything with (tests/library/test_arguments.c has those
 * of all others). */

#include "refused.h"

#include <math.h>

#define BLOCK EXAMPLE("solids/balanced_rock.obj")

START_TEST(solids) {
  tp_solid *solid = UNTOUCHED(tp_solid);
  const tp_solid_options options = tp_solid_options_default();
  REFUSED(tp_solid_of_file(NULL, BLOCK, &options, &message), "'solid'");
  REFUSED(tp_solid_of_file(&solid, NULL, &options, &message), "'path'");
  REFUSED(tp_solid_of_file(&solid, BLOCK, NULL, &message), "'options'");
  for (size_t k = 0; k < 2; k++) {
    const tp_solid_options sized = {.size = k == 0 ? 0 : 4096};
    REFUSED(tp_solid_of_file(&solid, BLOCK, &sized, &message), "the size");
  }
  ck_assert_ptr_eq(solid, UNTOUCHED(tp_solid));
}
END_TEST

START_TEST(strange_options) {
  static const double strange[] = {NAN, INFINITY, -INFINITY};
  tp_solid *solid = UNTOUCHED(tp_solid);
  tp_solid_options options;
  for (size_t k = 0; k < sizeof strange / sizeof strange[0]; k++) {
    options = tp_solid_options_default();
    options.unit_weight_kn_m3 = strange[k];
    REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "unit weight");
    options = tp_solid_options_default();
    options.up[1] = strange[k];
    REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "up");
    options = tp_solid_options_default();
    options.bands = strange + k;
    options.band_count = 1;
    REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "band");
  }
  options = tp_solid_options_default();
  options.friction_angle_deg = NAN;
  REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "friction");
  options = tp_solid_options_default();
  options.up[2] = 0;
  REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "up");
  options = tp_solid_options_default();
  options.length_unit = "ell";
  REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "mm");
  options = tp_solid_options_default();
  options.object = "roof";
  REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "roof");
  options = tp_solid_options_default();
  options.azimuths = TP_SOLID_AZIMUTHS + 1;
  REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "azimuths");
  options = tp_solid_options_default();
  options.band_count = 2;
  REFUSED(tp_solid_of_file(&solid, BLOCK, &options, &message), "no bands");
  ck_assert_ptr_eq(solid, UNTOUCHED(tp_solid));
}
END_TEST

START_TEST(scenes) {
  tp_solid *solid = UNTOUCHED(tp_solid);
  tp_scene *scene = NULL, *plain = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, EXAMPLE("solids/balanced_rock.yaml"), &message), TP_OK);
  ck_assert_int_eq(tp_scene_read(&plain, EXAMPLE("slab.yaml"), &message), TP_OK);
  REFUSED(tp_solve_solid(NULL, scene, &message), "'solid'");
  REFUSED(tp_solve_solid(&solid, NULL, &message), "'scene'");
  REFUSED(tp_solve_solid(&solid, plain, &message), "no 'solid'");
  ck_assert_ptr_eq(solid, UNTOUCHED(tp_solid));
  ck_assert(tp_scene_is_solid(scene) && !tp_scene_is_solid(plain) && !tp_scene_is_solid(NULL));
  ck_assert(tp_solid_is_undecided(NULL));
  ck_assert_int_eq(tp_solid_meets(NULL, 1), TP_DESIGN_OPEN);
  ck_assert_int_eq(tp_solve_solid(&solid, scene, &message), TP_OK);
  ck_assert(!tp_solid_is_undecided(solid));
  ck_assert_int_eq(tp_solid_meets(solid, 1.5), TP_DESIGN_MET);
  ck_assert_int_eq(tp_solid_meets(solid, 1.7), TP_DESIGN_NOT_MET);
  const tp_sheet_options sheet = tp_sheet_options_default();
  REFUSED(tp_report_sheet_solid(NULL, scene, solid, &sheet, &message), "'path'");
  REFUSED(tp_report_sheet_solid("/tmp/x.html", NULL, solid, &sheet, &message), "'scene'");
  REFUSED(tp_report_sheet_solid("/tmp/x.html", scene, NULL, &sheet, &message), "'solid'");
  REFUSED(tp_report_sheet_solid("/tmp/x.html", scene, solid, NULL, &message), "'options'");
  REFUSED(tp_report_sheet_solid("/tmp/x.txt", scene, solid, &sheet, &message),
          ".html, .md or .pdf");
  REFUSED(tp_report_sheet_solid("/tmp/x.html", plain, solid, &sheet, &message), "no 'solid'");
  tp_solid_free(solid);
  tp_scene_free(scene);
  tp_scene_free(plain);
}
END_TEST

START_TEST(reports) {
  char *text = &untouched;
  tp_solid *own = NULL;
  const tp_solid_options options = tp_solid_options_default();
  ck_assert_int_eq(tp_solid_of_file(&own, BLOCK, &options, &message), TP_OK);
  UNWRITTEN(tp_report_solid(NULL, own));
  UNWRITTEN(tp_report_solid(&text, NULL));
  UNWRITTEN(tp_report_solid_json(NULL, own));
  UNWRITTEN(tp_report_solid_json(&text, NULL));
  UNWRITTEN(tp_report_solid_csv(NULL, own));
  UNWRITTEN(tp_report_solid_csv(&text, NULL));
  UNWRITTEN(tp_report_solid_row_csv(NULL, own));
  UNWRITTEN(tp_report_solid_row_csv(&text, NULL));
  REFUSED(tp_report_solid_section(NULL, own, 45, &message), "'text'");
  REFUSED(tp_report_solid_section(&text, NULL, 45, &message), "'solid'");
  REFUSED(tp_report_solid_section(&text, own, NAN, &message), "azimuth");
  ck_assert_ptr_eq(text, &untouched);
  tp_solid_free(NULL);
  tp_solid_free(own);
}
END_TEST

SUITE(solid_arguments) {
  Suite *suite = suite_create("arguments of solids");
  TCase *tests = tcase_create("arguments of solids");
  tcase_add_test(tests, solids);
  tcase_add_test(tests, strange_options);
  tcase_add_test(tests, scenes);
  tcase_add_test(tests, reports);
  suite_add_tcase(suite, tests);
  return suite;
}
