/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments that no call can do anything with: NULL for every pointer in turn,
 * values outside of their enumeration, numbers that are none, sizes of options.
 *
 * NULL ended the program of whoever passed it. Every call says what is wrong, names the argument,
 * and leaves its outputs alone. Other calls are in test_analysis_arguments.c and the like. */

#include "common/message.h"
#include "common/notes.h"
#include "common/options.h"
#include "example_scene.h"
#include "refused.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

START_TEST(scenes) {
  tp_scene *scene = UNTOUCHED(tp_scene);
  REFUSED(tp_scene_read(NULL, "x", &message), "'scene'");
  REFUSED(tp_scene_read(&scene, NULL, &message), "'path'");
  static const char *const setting = "a=1", *const none = NULL, *const bare = "a";
  REFUSED(tp_scene_read_with(NULL, "x", "", NULL, 0, &message), "'scene'");
  REFUSED(tp_scene_read_with(&scene, NULL, "", NULL, 0, &message), "'path'");
  REFUSED(tp_scene_read_with(&scene, "x", NULL, NULL, 0, &message), "'unit'");
  REFUSED(tp_scene_read_with(&scene, "x", "", NULL, 1, &message), "'settings'");
  REFUSED(tp_scene_read_with(&scene, "x.dxf", "", &none, 1, &message), "setting 1");
  REFUSED(tp_scene_read_with(&scene, "x.dxf", "", &bare, 1, &message), "KEY=VALUE");
  REFUSED(tp_scene_read_with(&scene, "/no/such.dxf", "mm", &setting, 1, &message), "'a'");
  REFUSED(tp_scene_read_text(NULL, "x", "x", &message), "'scene'");
  REFUSED(tp_scene_read_text(&scene, NULL, "x", &message), "'text'");
  REFUSED(tp_scene_read_text(&scene, "x", NULL, &message), "'name'");
  ck_assert_int_eq(tp_scene_read(&scene, "/no/such/file", NULL), TP_SYSTEM_FAILED);
  ck_assert_int_eq(tp_scene_read_text(&scene, "x", "x", NULL), TP_BAD_INPUT);
  ck_assert_ptr_eq(scene, UNTOUCHED(tp_scene));
  tp_scene_free(NULL);
}
END_TEST

START_TEST(figures_of_solids) {
  const tp_solid_options options = tp_solid_options_default();
  const tp_figure_consent none = {0};
  tp_solid *own = NULL;
  ck_assert_int_eq(
      tp_solid_of_file(&own, TP_EXAMPLES "/solids/balanced_rock.obj", &options, &message), TP_OK);
  REFUSED(tp_report_figure_solid(NULL, own, &message), "'path'");
  REFUSED(tp_report_figure_solid("/tmp/x.svg", NULL, &message), "'solid'");
  REFUSED(tp_report_figure_solid_if(NULL, own, none, &message), "'path'");
  REFUSED(tp_report_figure_solid_if("/tmp/x.svg", NULL, none, &message), "'solid'");
  REFUSED(tp_report_figure_solid("/tmp/x.dxf", own, &message), ".png or .glb");
  ck_assert_ptr_null(tp_solid_safety_of(NULL));
  ck_assert_ptr_null(tp_solid_safety_of(own)); /* a file has no friction to be safe with */
  own->triangles++;
  REFUSED(tp_report_figure_solid("/tmp/x.svg", own, &message), "has changed");
  tp_solid_free(own);
}
END_TEST

START_TEST(figures_of_many_blocks) {
  const tp_solve_options options = tp_solve_options_default();
  const tp_figure_consent none = {0};
  const tp_sheet_options sheet = tp_sheet_options_default();
  tp_scene *scene = NULL, *plain = example_scene();
  tp_block_system *own = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, TP_EXAMPLES "/blocks/toppling_slope.yaml", &message),
                   TP_OK);
  ck_assert_int_eq(tp_solve_block_system(&own, scene, &options, &message), TP_OK);
  REFUSED(tp_report_figure_block_system(NULL, scene, own, &message), "'path'");
  REFUSED(tp_report_figure_block_system("/tmp/x.svg", NULL, own, &message), "'scene'");
  REFUSED(tp_report_figure_block_system("/tmp/x.svg", scene, NULL, &message), "'system'");
  REFUSED(tp_report_figure_block_system_if(NULL, scene, own, none, &message), "'path'");
  REFUSED(tp_report_figure_block_system_if("/tmp/x.svg", NULL, own, none, &message), "'scene'");
  REFUSED(tp_report_figure_block_system_if("/tmp/x.svg", scene, NULL, none, &message), "'system'");
  REFUSED(tp_report_figure_block_system("/tmp/x.svg", plain, own, &message), "of this scene");
  REFUSED(tp_report_figure_block_system("/tmp/x.txt", scene, own, &message), ".png or .dxf");
  REFUSED(tp_report_sheet_block_system(NULL, scene, own, &sheet, &message), "'path'");
  REFUSED(tp_report_sheet_block_system("/tmp/x.html", NULL, own, &sheet, &message), "'scene'");
  REFUSED(tp_report_sheet_block_system("/tmp/x.html", scene, NULL, &sheet, &message), "'system'");
  REFUSED(tp_report_sheet_block_system("/tmp/x.html", scene, own, NULL, &message), "'options'");
  REFUSED(tp_report_sheet_block_system("/tmp/x.txt", scene, own, &sheet, &message),
          ".html, .md or .pdf");
  REFUSED(tp_report_sheet_block_system("/tmp/x.html", plain, own, &sheet, &message),
          "of this scene");
  tp_block_system_free(own);
  tp_scene_free(plain);
  tp_scene_free(scene);
}
END_TEST

START_TEST(solutions) {
  tp_scene *scene = example_scene();
  tp_solution *own = example_solution(scene), *solution = UNTOUCHED(tp_solution);
  tp_solve_options options = tp_solve_options_default();
  char *text = &untouched;
  REFUSED(tp_solve(NULL, scene, &options, &message), "'solution'");
  REFUSED(tp_solve(&solution, NULL, &options, &message), "'scene'");
  REFUSED(tp_solve(&solution, scene, NULL, &message), "'options'");
  static const int digits[] = {0, -1, TP_DIGITS_MAX + 1, 2147483647, -2147483647 - 1};
  for (size_t k = 0; k < sizeof digits / sizeof digits[0]; k++) {
    options.digits = digits[k];
    REFUSED(tp_solve(&solution, scene, &options, &message), "digits");
  }
  options = tp_solve_options_default();
  for (int k = -1; k <= TP_LEVELS; k += TP_LEVELS + 1) {
    options.level = (tp_level)k;
    REFUSED(tp_solve(&solution, scene, &options, &message), "level");
    ck_assert_str_eq(tp_level_name((tp_level)k), "unknown");
  }
  options = tp_solve_options_default();
  for (int k = -1; k <= TP_PIVOTS_GOVERNING + 1; k += TP_PIVOTS_GOVERNING + 2) {
    options.pivots = (tp_pivots_listed)k;
    REFUSED(tp_solve(&solution, scene, &options, &message), "pivots");
  }
  ck_assert_ptr_eq(solution, UNTOUCHED(tp_solution));
  ck_assert(tp_solution_is_undecided(NULL));
  tp_level level = TP_LEVEL_BALL;
  ck_assert(!tp_level_read(NULL, "ball") && !tp_level_read(&level, NULL));
  const tp_solution *const two[2] = {own, NULL};
  UNWRITTEN(tp_report_text(NULL, own));
  UNWRITTEN(tp_report_text(&text, NULL));
  UNWRITTEN(tp_report_elements(NULL, own));
  UNWRITTEN(tp_report_elements(&text, NULL));
  UNWRITTEN(tp_report_notes(NULL, own));
  UNWRITTEN(tp_report_notes(&text, NULL));
  UNWRITTEN(tp_report_json(NULL, own));
  UNWRITTEN(tp_report_json(&text, NULL));
  UNWRITTEN(tp_report_table(NULL, two, 1));
  UNWRITTEN(tp_report_table(&text, NULL, 1));
  UNWRITTEN(tp_report_table(&text, two, 2));
  UNWRITTEN(tp_report_csv(NULL, two, 1));
  UNWRITTEN(tp_report_csv(&text, NULL, 1));
  UNWRITTEN(tp_report_csv(&text, two, 2));
  UNWRITTEN(tp_report_effects(NULL, own));
  UNWRITTEN(tp_report_effects(&text, NULL));
  UNWRITTEN(tp_report_drawing(NULL, scene));
  UNWRITTEN(tp_report_drawing(&text, NULL));
  UNWRITTEN(tp_report_json_pivots(NULL, own, TP_PIVOTS_ALL));
  UNWRITTEN(tp_report_json_pivots(&text, NULL, TP_PIVOTS_ALL));
  REFUSED(tp_report_json_outlines(NULL, scene, own, TP_PIVOTS_ALL, &message), "'text'");
  REFUSED(tp_report_json_outlines(&text, NULL, own, TP_PIVOTS_ALL, &message), "'scene'");
  REFUSED(tp_report_json_outlines(&text, scene, NULL, TP_PIVOTS_ALL, &message), "'solution'");
  ck_assert_int_eq(tp_solution_meets(NULL, 1), TP_DESIGN_OPEN);
  ck_assert_int_eq(tp_solution_meets(own, NAN), TP_DESIGN_OPEN);
  ck_assert_int_eq(tp_case_meets(NULL, 1), TP_DESIGN_OPEN);
  REFUSED(tp_report_figure(NULL, scene, own, &message), "'path'");
  REFUSED(tp_report_figure("/tmp/x.svg", NULL, own, &message), "'scene'");
  REFUSED(tp_report_figure("/tmp/x.svg", scene, NULL, &message), "'solution'");
  const tp_figure_consent none = {0};
  REFUSED(tp_report_figure_if(NULL, scene, own, none, &message), "'path'");
  REFUSED(tp_report_figure_if("/tmp/x.svg", NULL, own, none, &message), "'scene'");
  REFUSED(tp_report_figure_if("/tmp/x.svg", scene, NULL, none, &message), "'solution'");
  ck_assert(!tp_figure_is_file_name(NULL));
  tp_sheet_options sheet = tp_sheet_options_default();
  REFUSED(tp_report_sheet(NULL, scene, own, &sheet, &message), "'path'");
  REFUSED(tp_report_sheet("/tmp/x.html", NULL, own, &sheet, &message), "'scene'");
  REFUSED(tp_report_sheet("/tmp/x.html", scene, NULL, &sheet, &message), "'solution'");
  REFUSED(tp_report_sheet("/tmp/x.html", scene, own, NULL, &message), "'options'");
  REFUSED(tp_report_sheet("/tmp/x.txt", scene, own, &sheet, &message), ".html, .md or .pdf");
  sheet.size = 0;
  REFUSED(tp_report_sheet("/tmp/x.html", scene, own, &sheet, &message), "size");
  ck_assert(!tp_sheet_is_file_name(NULL));
  ck_assert(!tp_sheet_is_language(NULL));
  ck_assert_ptr_eq(text, &untouched);
  tp_solution_free(NULL);
  tp_solution_free(own);
  tp_scene_free(scene);
}
END_TEST

/* Options of a program compiled with an older library end sooner: what lies beyond is not read, and
 * is at its default. */
START_TEST(older_options) {
  tp_scene *scene = example_scene();
  tp_solution *solution = NULL, *refused = UNTOUCHED(tp_solution);
  tp_solve_options options = tp_solve_options_default();
  options.size = offsetof(tp_solve_options, level);
  options.limit = false;
  options.level = (tp_level)-1;
  options.pivots = (tp_pivots_listed)-1;
  ck_assert_int_eq(tp_solve(&solution, scene, &options, &message), TP_OK);
  ck_assert_int_eq(solution->cases[0].limit.kind, TP_LIMIT_NOT_ASKED);
  ck_assert(solution->cases[0].pivots[0].computed);
  const size_t sizes[] = {0, 1, sizeof options - 1, sizeof options + 8, SIZE_MAX};
  for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++) {
    options = tp_solve_options_default();
    options.size = sizes[k];
    REFUSED(tp_solve(&refused, scene, &options, &message), "tp_solve: the size of 'options'");
  }
  ck_assert_ptr_eq(refused, UNTOUCHED(tp_solution));
  tp_solution_free(solution);
  tp_scene_free(scene);
}
END_TEST

/* Defaults are written as far as the caller's struct goes; of a larger one than the library knows
 * the rest is zero, and its size refused. */
START_TEST(defaults) {
  tp_solve_options two[2], untold;
  const size_t short_of = offsetof(tp_solve_options, level);
  memset(&untold, 0x5a, sizeof untold);
  memset(two, 0x5a, sizeof two);
  tp_solve_options_init(two, short_of);
  ck_assert_uint_eq(two->size, short_of);
  ck_assert(two->limit && two->digits == 9);
  ck_assert_mem_eq(&two->level, &untold.level, sizeof *two - short_of);
  tp_solve_options_init(two, sizeof two);
  ck_assert_uint_eq(two->size, sizeof two);
  ck_assert_uint_eq(two[1].size, 0);
  tp_options_fill(NULL, sizeof two, &untold);
  untold.size = sizeof untold;
  tp_solve_options_init(&untold, 4); /* no room for a size */
  ck_assert_uint_eq(untold.size, sizeof untold);
}
END_TEST

/* Every other call that takes options. */
START_TEST(sizes_of_options) {
  tp_scene *scene = example_scene();
  char *text = &untouched;
  const tp_found nothing = {0};
  for (size_t k = 0; k < 2; k++) {
    const size_t size = k == 0 ? 0 : 4096;
    const tp_find_options find = {.size = size, .key = "block.slab.width"};
    const tp_derive_options derive = {.size = size};
    const tp_chart_fos_options fos = {.size = size};
    const tp_chart_mechanisms_options mechanisms = {.size = size};
    const tp_chart_map_options map = {.size = size};
    tp_found *found = UNTOUCHED(tp_found);
    tp_derivation *derivation = UNTOUCHED(tp_derivation);
    tp_chart *chart = UNTOUCHED(tp_chart);
    REFUSED(tp_find(&found, scene, &find, &message), "tp_find: the size");
    UNWRITTEN(tp_report_found(&text, &nothing, &find));
    REFUSED(tp_derive(&derivation, scene, &derive, &message), "tp_derive: the size");
    REFUSED(tp_chart_fos(&chart, &fos, &message), "tp_chart_fos: the size");
    REFUSED(tp_chart_mechanisms(&chart, &mechanisms, &message), "tp_chart_mechanisms: the size");
    REFUSED(tp_chart_map(&chart, &map, &message), "tp_chart_map: the size");
    ck_assert_ptr_eq(found, UNTOUCHED(tp_found));
    ck_assert_ptr_eq(derivation, UNTOUCHED(tp_derivation));
    ck_assert_ptr_eq(chart, UNTOUCHED(tp_chart));
  }
  ck_assert_ptr_eq(text, &untouched);
  tp_scene_free(scene);
}
END_TEST

/* Of a path that is too long for a message, the position stays. */
/* A library whose results have grown since a program was compiled, and one that is older than its
 * headers: the program finds the second case, and knows what is not there. */
START_TEST(results_that_grow) {
  typedef struct grown {
    tp_case known;
    double added;
  } grown;
  static grown cases[2];
  tp_solution result = {.size = sizeof result + 8, .case_size = sizeof(grown), .case_count = 2};
  result.cases = &cases[0].known;
  ck_assert_ptr_eq(tp_solution_case(&result, 0), &cases[0].known);
  ck_assert_ptr_eq(tp_solution_case(&result, 1), &cases[1].known);
  ck_assert(TP_HAS_MEMBER(&result, poses) && TP_HAS_MEMBER(&result, notes));
  result.size = offsetof(tp_solution, notes);
  ck_assert(TP_HAS_MEMBER(&result, title) && !TP_HAS_MEMBER(&result, notes));
  tp_scene *scene = example_scene();
  tp_solution *own = example_solution(scene);
  ck_assert_uint_eq(own->size, sizeof *own);
  ck_assert_uint_eq(own->case_size, sizeof own->cases[0]);
  for (size_t k = 0; k < own->case_count; k++) {
    ck_assert_ptr_eq(tp_solution_case(own, k), &own->cases[k]);
  }
  tp_solution_free(own);
  tp_scene_free(scene);
}
END_TEST

START_TEST(long_paths) {
  static const size_t lengths[] = {10, 500, 504, 505, 506, 510, 511, 512, 513, 1000, 5000};
  for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++) {
    char *name = calloc(lengths[k] + 1, 1);
    memset(name, 'd', lengths[k]);
    tp_scene *scene = NULL;
    ck_assert_int_eq(
        tp_scene_read_text(&scene, "topple: 1\nlength_unit: mm\nblok: 1\n", name, &message),
        TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, "d:3:") != NULL, "%s", message.text);
    ck_assert_msg(strstr(message.text, "blok") != NULL, "%s", message.text);
    free(name);
  }
}
END_TEST

/* A note keeps all of its text. A message is as long as the caller's array, and says where it is
 * cut off, also of white space that takes less room once it is plain. */
START_TEST(long_texts) {
  enum { WIDE = 3, COUNT = 1000 };
  char wide[WIDE * COUNT + 1];
  for (size_t k = 0; k < COUNT; k++) memcpy(wide + WIDE * k, "\u2028", WIDE + 1);
  ck_assert_int_eq(tp_fail(&message, TP_BAD_INPUT, (tp_place){0}, "(%s)", wide), TP_BAD_INPUT);
  ck_assert_msg(strstr(message.text, " …") != NULL, "'%s'", message.text);
  tp_notes notes = {0}, more = {0};
  ck_assert_int_eq(
      tp_notes_add(&notes, &message, TP_NOTE, (tp_place){wide, 1, 2}, "(%s\x01)", wide), TP_OK);
  ck_assert_int_eq(tp_notes_append(&more, &notes, &message), TP_OK);
  tp_notes_clear(&notes);
  ck_assert_uint_eq(strlen(more.items[0].text), COUNT + strlen("(\\x01)"));
  ck_assert_uint_eq(strlen(more.items[0].place), WIDE * COUNT + strlen(":1:2"));
  tp_notes_clear(&more);
}
END_TEST

SUITE(arguments) {
  Suite *suite = suite_create("arguments");
  TCase *tests = tcase_create("arguments");
  tcase_set_timeout(tests, 600);
  tcase_add_test(tests, scenes);
  tcase_add_test(tests, solutions);
  tcase_add_test(tests, figures_of_solids);
  tcase_add_test(tests, figures_of_many_blocks);
  tcase_add_test(tests, older_options);
  tcase_add_test(tests, defaults);
  tcase_add_test(tests, sizes_of_options);
  tcase_add_test(tests, results_that_grow);
  tcase_add_test(tests, long_paths);
  tcase_add_test(tests, long_texts);
  suite_add_tcase(suite, tests);
  return suite;
}
