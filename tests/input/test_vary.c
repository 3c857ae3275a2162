/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes in which numbers are others: what follows a parameter, chains of points that scenes share,
 * exact numbers as text, and what is refused. */

#include "scene/scene.h"
#include "varied_scene.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What names a parameter follows it, and so do parameters behind it; one that is set itself does
 * not. A scene that was varied is varied again. */
START_TEST(parameters_follow) {
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "2*a", "1/a") RING REST);
  expect_equal(solved(with(scene, "a", E(4))),
               solved(read_text(HEAD PARAMETERS("4", "8", "1/4") RING REST)));
  expect_equal(solved(with(scene, "parameters.b", T("20/3"))),
               solved(read_text(HEAD PARAMETERS("3", "20/3", "1/3") RING REST)));
  tp_scene *once = with(scene, "b", E(5));
  tp_scene_free(scene);
  tp_scene *twice = with(once, "a", E(2)), *back = with(once, "b", E(7));
  tp_scene_free(once);
  expect_equal(solved(twice), solved(read_text(HEAD PARAMETERS("2", "5", "1/2") RING REST)));
  expect_equal(solved(back), solved(read_text(HEAD PARAMETERS("3", "7", "1/3") RING REST)));
}
END_TEST

START_TEST(several_at_once) {
  static const char *const keys[] = {"a", "tilt.angle_deg", "block.outline.3.2"};
  const tp_exact values[] = {T("0.4e1"), E(12.5), T("19/3")};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST), *varied = NULL;
  DO(tp_scene_with_numbers(&varied, scene, keys, values, 3, &message));
  expect_equal(
      solved(varied),
      solved(read_text(HEAD "block: {outline: [[0, 0], [4, 0], [4, 19/3], [0, 6]], thickness: "
                            "1}\nfriction_angle_deg: 30\n"
                            "tilt: {towards: left, angle_deg: 12.5}\n")));
  DO(tp_scene_with_numbers(&varied, scene, keys, values, 0, &message));
  expect_equal(solved(varied), solved(scene));
  scene = slab(3);
  static const char *const built[] = {"block.outline.2.1", "block.outline.3.1", "tilt.angle_deg"};
  const tp_exact others[] = {E(4), E(4), E(12.5)};
  DO(tp_scene_with_numbers(&varied, scene, built, others, 3, &message));
  tp_scene *anew = slab(4);
  DO(tp_scene_set_tilt_angle_deg(anew, E(12.5), &message));
  expect_equal(solved(varied), solved(anew));
  tp_scene_free(scene);
}
END_TEST

/* A scene and the one made of it are changed, and freed, each by itself. */
START_TEST(each_by_itself) {
  static const double hole[] = {1, 1, 2, 1, 2, 2}, other[] = {1, 4, 1.5, 4, 1.5, 5};
  tp_scene *scene = slab(3);
  for (int k = 0; k < 3; k++) { /* a list whose room is not full */
    DO(tp_scene_add_rounded_vertex(scene, E(3), E(6), E(0.25), &message));
  }
  tp_scene *varied = with(scene, "tilt.angle_deg", E(5));
  tp_scene_free(scene);
  for (int k = 0; k < 30; k++) {
    DO(tp_scene_add_rounded_vertex(varied, E(0), E(6), E(0.25), &message));
  }
  tp_bounded radius = {0};
  DO(tp_scene_number(&radius, varied, "block.rounded.corners.33.radius", &message));
  ck_assert(radius.value == 0.25 && radius.error == 0);
  tp_scene_free(varied);
  scene = slab(3);
  DO(tp_scene_add_hole(scene, tp_coordinates_of(hole, 3), &message));
  varied = with(scene, "block.outline.3.2", E(7));
  char *before = solve(varied, 9);
  DO(tp_scene_add_hole(scene, tp_coordinates_of(other, 3), &message));
  DO(tp_scene_set_slab(scene, E(5), E(7), &message));
  expect_equal(before, solve(varied, 9));
  before = solve(scene, 9);
  DO(tp_scene_set_title(varied, "Another", &message));
  DO(tp_scene_add_hole(varied, tp_coordinates_of(other, 3), &message));
  expect_equal(before, solve(scene, 9));
  tp_scene_free(scene);
  tp_scene_free(varied);
}
END_TEST

/* A ring whose last point comes to lie on its first is closed there, as in a file. */
START_TEST(closed_ring) {
  static const double five[] = {0, 0, 3, 0, 3, 6, 0, 6, 0, 3};
  tp_scene *scene = slab(3), *varied = NULL;
  DO(tp_scene_set_outline(scene, tp_coordinates_of(five, 5), &message));
  varied = with(scene, "block.outline.5.2", E(0));
  expect_equal(solved(varied), solved(slab(3)));
  ck_assert_int_eq(tp_scene_with(&varied, scene, "block.outline.6.2", E(0), &message),
                   TP_BAD_INPUT);
  tp_scene_free(scene);
}
END_TEST

/* Files that a scene names are read once: it may be varied when they are gone. What was noted of
 * them is noted of the scenes that share their points. */
START_TEST(files_once) {
  char folder[] = "/tmp/topple_vary_XXXXXX", path[64], csv[64];
  ck_assert_ptr_nonnull(mkdtemp(folder));
  snprintf(path, sizeof path, "%s/scene.yaml", folder);
  snprintf(csv, sizeof csv, "%s/ring.csv", folder);
  FILE *file = fopen(csv, "w");
  fputs("x,y\n0,0\n3,0\n3,0\n3,6\n0,6\n", file);
  fclose(file);
  file = fopen(path, "w");
  fputs(HEAD "block: {outline: ring.csv}\n" REST, file);
  fclose(file);
  tp_scene *scene = NULL, *varied = NULL;
  DO(tp_scene_read(&scene, path, &message));
  unlink(csv);
  unlink(path);
  rmdir(folder);
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  varied = with(scene, "tilt.angle_deg", E(5));
  ck_assert_int_eq(tp_scene_with(&varied, scene, "block.outline", E(5), &message), TP_BAD_INPUT);
  tp_scene_free(scene);
  DO(tp_solve(&solution, varied, &options, &message));
  ck_assert_uint_eq(solution->notes.count, 1);
  ck_assert_ptr_nonnull(strstr(solution->notes.items[0].text, "repeats"));
  ck_assert_ptr_nonnull(strstr(solution->notes.items[0].place, "ring.csv:4"));
  ck_assert(solution->block.area_m2.value == 18 && solution->cases[0].towards == TP_TOWARDS_LEFT);
  tp_solution_free(solution);
  tp_scene_free(varied);
}
END_TEST

/* All digits: read by C they are the double, and as a number of a scene they are the number. */
START_TEST(exact_texts) {
  static const double doubles[] = {0.1, 1, 2.5e-300, 1e300, 0x1p-1000, 0.000123, 1e-7, 3e22, 0.5};
  static const char *const others[][2] = {
      {"1/3", "1/3"},      {"0.1", "0.1"},      {"2/4", "0.5"},    {"100", "100"},
      {"1e3", "1000"},     {"1e-9", "1e-9"},    {"12.50", "12.5"}, {"22/7", "22/7"},
      {"1/1024000", NULL}, {"1234.5678", NULL}, {"1/7e9", NULL}};
  tp_scene *scene = slab(3);
  DO(tp_scene_set_thickness(scene, E(1), &message));
  char *text = NULL;
  for (size_t k = 0; k < sizeof doubles / sizeof doubles[0]; k++) {
    tp_scene *varied = with(scene, "block.thickness", E(doubles[k]));
    DO(tp_scene_number_text(&text, varied, "block.thickness", &message));
    ck_assert_msg(strtod(text, NULL) == doubles[k], "%.17g: %s", doubles[k], text);
    tp_scene *again = with(scene, "block.thickness", T(text));
    free(text);
    tp_bounded number = {0};
    DO(tp_scene_number(&number, again, "block.thickness", &message));
    ck_assert_msg(number.value == doubles[k] && number.error == 0, "%.17g", doubles[k]);
    tp_scene_free(again);
    tp_scene_free(varied);
  }
  for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
    tp_scene *varied = with(scene, "block.thickness", T(others[k][0])), *again = NULL;
    char *twice = NULL;
    DO(tp_scene_number_text(&text, varied, "block.thickness", &message));
    if (others[k][1] != NULL) ck_assert_str_eq(text, others[k][1]);
    again = with(scene, "block.thickness", T(text));
    DO(tp_scene_number_text(&twice, again, "block.thickness", &message));
    expect_equal(text, twice);
    tp_scene_free(again);
    tp_scene_free(varied);
  }
  tp_scene *third = with(scene, "block.outline.1.1", T("-1/3"));
  tp_bounded number = {0};
  DO(tp_scene_number(&number, third, "block.outline.1.1", &message));
  ck_assert(number.value == -1.0 / 3 && number.error > 0 && number.error < 1e-16);
  tp_scene_free(third);
  tp_scene_free(scene);
}
END_TEST

static void refuse(const tp_scene *scene, const char *key, tp_exact value, const char *why) {
  static char untouched;
  tp_scene *varied = (tp_scene *)(void *)&untouched;
  ck_assert_int_eq(tp_scene_with(&varied, scene, key, value, &message), TP_BAD_INPUT);
  ck_assert_msg(strstr(message.text, why) != NULL, "%s: '%s'", key, message.text);
  ck_assert_ptr_eq(varied, (tp_scene *)(void *)&untouched);
}

START_TEST(refused) {
  tp_scene *built = slab(3);
  tp_scene *file =
      read_text("topple: 1\ntitle: \"5\"\nlength_unit: m\n" PARAMETERS("3", "6", "1") RING REST);
  tp_scene *const both[] = {built, file};
  for (int k = 0; k < 2; k++) {
    const tp_scene *scene = both[k];
    refuse(scene, "nothing", E(1), "scene in memory");
    refuse(scene, "nothing", E(1), "there is no 'nothing' here");
    refuse(scene, "", E(1), "there is no '' here");
    refuse(scene, "..", E(1), "there is no '' here");
    refuse(scene, "tilt.angle", E(1), "there is no 'angle' here; did you mean 'angle_deg'?");
    refuse(scene, "block.outlin.1.1", E(1), "did you mean 'outline'?");
    refuse(scene, "block.outline.0.1", E(1), "there is no '0' here");
    refuse(scene, "block.outline.5.1", E(1), "there is no '5' here");
    refuse(scene, "block.outline.1.3", E(1), "there is no '3' here");
    refuse(scene, "block.outline.1.x", E(1), "there is no 'x' here");
    refuse(scene, "block.outline.99999999999999999999.1", E(1), "there is no '9999");
    refuse(scene, "block.slab.width", E(1), "there is no 'slab' here");
    refuse(scene, "loads.bond_kpa", E(1), "there is no 'loads' here");
    refuse(scene, "block.outline.1", E(1), "is a list or a map; a single number can be found");
    refuse(scene, "tilt", E(1), "is a list or a map");
    refuse(scene, "tilt.angle_deg", E(91), "angle_deg must lie in [0°, 90°]");
    refuse(scene, "friction_angle_deg", E(-1), "friction_angle_deg must lie in [0°, 90°)");
    refuse(scene, "tilt.angle_deg", E(0x1p-1030), "tp_scene_with: tilt.angle_deg is outside");
    refuse(scene, "tilt.angle_deg", T("a"), "tp_scene_with: tilt.angle_deg: 'a' is not a number");
    refuse(scene, "tilt.angle_deg", T(NULL), "must be a finite number");
  }
  refuse(file, "title", E(1), "scene in memory:2:8: this is not a number of the scene");
  refuse(file, "topple", E(1), "scene in memory:1:9: this is not a number of the scene");
  refuse(file, "tilt.towards", E(1), "this is not a number of the scene");
  refuse(file, "length_unit", E(1), "this is not a number of the scene");
  refuse(file, "c", E(-1), "thickness must be above zero, not -1");
  tp_scene *varied = NULL;
  static const char *const twice[] = {"tilt.angle_deg", "friction_angle_deg", "tilt.angle_deg"};
  static const char *const missing[] = {"tilt.angle_deg", NULL};
  const tp_exact values[] = {E(1), E(2), E(3)};
  ck_assert_int_eq(tp_scene_with_numbers(&varied, built, twice, values, 3, &message), TP_BAD_INPUT);
  ck_assert_str_eq(message.text, "tp_scene_with_numbers: 'tilt.angle_deg' is given twice; leave "
                                 "out one of them");
  ck_assert_int_eq(tp_scene_with_numbers(&varied, file, missing, values, 2, &message),
                   TP_BAD_INPUT);
  ck_assert_str_eq(message.text, "tp_scene_with_numbers: key 2 must not be NULL");
  ck_assert_ptr_null(varied);
  tp_bounded number = {0};
  char *text = NULL;
  ck_assert_int_eq(tp_scene_number(&number, file, "tilt", &message), TP_BAD_INPUT);
  ck_assert_int_eq(tp_scene_number_text(&text, built, "tilt", &message), TP_BAD_INPUT);
  ck_assert_int_eq(tp_scene_number_text(&text, file, "tilt.towards", &message), TP_BAD_INPUT);
  ck_assert_ptr_null(text);
  tp_scene_free(built);
  tp_scene_free(file);
}
END_TEST

#define MADE(step, seed, deviation)                                                                \
  HEAD "parameters: {s: " deviation "}\n"                                                          \
       "block: {outline: [[1, 0.5], [4, 0.5], [4, 2], [1, 2]]}\n"                                  \
       "base: {profile: {measured: [[0, 0], [2, " step                                             \
       "], [5, 0]], noise: {deviation: s, seed: " seed "}}, place: rest}\n" REST

/* A profile made by rule is made anew where a number of its rule is another: one of its own, one of
 * the points that it begins with, a parameter that it names; else scenes share it. */
START_TEST(made_anew) {
  static const char *const rules[] = {MADE("0.25", "1", "1/16"), MADE("0.25", "1", "0.0625")};
  tp_scene *scene = read_text(rules[0]);
  expect_equal(solved(with(scene, "friction_angle_deg", E(30))), solved(read_text(rules[1])));
  expect_equal(solved(with(scene, "base.profile.noise.seed", E(2))),
               solved(read_text(MADE("0.25", "2", "0.0625"))));
  expect_equal(solved(with(scene, "base.profile.measured.2.2", E(0.5))),
               solved(read_text(MADE("0.5", "1", "0.0625"))));
  expect_equal(solved(with(scene, "s", E(0.125))), solved(read_text(MADE("0.25", "1", "0.125"))));
  tp_scene_free(scene);
  scene = read_text(HEAD "block: {outline: [[1, 3], [4, 3], [4, 5], [1, 5]]}\n"
                         "base: {profile: {teeth: {count: 8, wavelength: 1, amplitude: 1/4, "
                         "left_end: peak}}, place: rest}\n" REST);
  tp_scene *same = with(scene, "tilt.angle_deg", E(5));
  tp_scene *other = with(scene, "base.profile.teeth.amplitude", E(0.5));
  ck_assert_ptr_eq(same->base.profile.y, scene->base.profile.y);
  ck_assert_ptr_ne(other->base.profile.y, scene->base.profile.y);
  tp_scene_free(scene);
  tp_scene_free(other);
  expect_equal(
      solved(same),
      solved(read_text(
          HEAD
          "block: {outline: [[1, 3], [4, 3], [4, 5], [1, 5]]}\n"
          "base: {profile: {teeth: {count: 8, wavelength: 1, amplitude: 1/4, left_end: peak}}, "
          "place: rest}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 5}\n")));
}
END_TEST

SUITE(vary) {
  Suite *suite = suite_create("vary");
  TCase *tests = tcase_create("scenes");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, parameters_follow);
  tcase_add_test(tests, several_at_once);
  tcase_add_test(tests, each_by_itself);
  tcase_add_test(tests, closed_ring);
  tcase_add_test(tests, files_once);
  tcase_add_test(tests, exact_texts);
  tcase_add_test(tests, refused);
  tcase_add_test(tests, made_anew);
  suite_add_tcase(suite, tests);
  return suite;
}
