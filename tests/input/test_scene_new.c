/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes built in memory: each has, byte for byte, the solution of the file that says the same, but
 * for what its effects are called for by and how long they took. */

#include "built_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Two feet, and a hollow between them. */
static const double feet[] = {0, 0, 1, 0, 1.5, 0.25, 3, 0.125, 3.5, 4, 0.25, 4.5};

START_TEST(outlines) {
  static const char *const units[] = {"mm", "cm", "m", "km", "in", "ft"};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    char text[400];
    snprintf(text, sizeof text,
             "topple: 1\nlength_unit: %s\nblock:\n  outline: [[0, 0], [1, 0], [1.5, 0.25], "
             "[3, 0.125], [3.5, 4], [0.25, 4.5]]\n  unit_weight_kn_m3: 26\n"
             "friction_angle_deg: 31.5\ntilt: {angle_deg: 12}\n",
             units[k]);
    tp_scene *scene = new_scene(units[k]);
    DO(tp_scene_set_outline(scene, tp_coordinates_of(feet, 6), &message));
    DO(tp_scene_set_unit_weight_kn_m3(scene, E(26), &message));
    DO(tp_scene_set_friction_angle_deg(scene, E(31.5), &message));
    DO(tp_scene_set_tilt_angle_deg(scene, E(12), &message));
    tp_scene *read = NULL;
    DO(tp_scene_read_text(&read, text, "x", &message));
    tp_scene_free(read);
    if (strcmp(units[k], "m") == 0 || strcmp(units[k], "ft") == 0 || strcmp(units[k], "in") == 0) {
      expect_same(scene, text); /* without a caution, which has a place */
    } else {
      char *own = solve(scene, 9);
      free(own);
      tp_scene_free(scene);
    }
  }
}
END_TEST

/* One call for the outline in an array: what the calls that build its scene lead to. */
START_TEST(outline_at_once) {
  tp_solution *solution = NULL;
  char *text = NULL;
  DO(tp_solve_outline(&solution, feet, 6, "cm", 31.5, 12.25, &message));
  ck_assert_int_eq(solution->case_count, 2);
  ck_assert_str_eq(tp_mechanism_name(solution->cases[0].mechanism), "stands");
  ck_assert_int_eq(tp_report_csv(&text, (const tp_solution *const *)&solution, 1), TP_OK);
  tp_scene *scene = new_scene("cm");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(feet, 6), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(31.5), &message));
  DO(tp_scene_set_tilt_angle_deg(scene, E(12.25), &message));
  const tp_solve_options options = tp_solve_options_default();
  tp_solution *built = NULL;
  char *other = NULL;
  DO(tp_solve(&built, scene, &options, &message));
  ck_assert_int_eq(tp_report_csv(&other, (const tp_solution *const *)&built, 1), TP_OK);
  ck_assert_int_eq(strcmp(text, other), 0);
  tp_solution_free(solution);
  tp_solution_free(built);
  tp_scene_free(scene);
  free(text);
  free(other);
}
END_TEST

/* Decimals, fractions, doubles that are no decimal of a few digits; a ring that is closed. */
START_TEST(exact_numbers) {
  static const char *const texts[] = {"0",      "0",   "1/3",     "-0.1", "0.7",  "0",
                                      "7.1e-1", "2/3", "-1.5e-1", "0.9",  "0.00", "0/7"};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_text(texts, 6), &message));
  DO(tp_scene_set_friction_angle_deg(scene, T("100/3"), &message));
  DO(tp_scene_set_tilt_towards(scene, true, false, &message));
  expect_same(scene, "topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [1/3, -0.1], [0.7, 0], "
                     "[0.71, 2/3], [-0.15, 0.9]]}\nfriction_angle_deg: 100/3\n"
                     "tilt: {towards: left}\n");
  static const double tenths[] = {0, 0, 0.1, 0, 0.1, 0.3, 0, 0.3};
  scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(tenths, 4), &message));
  expect_same(scene, "topple: 1\nlength_unit: m\n"
                     "parameters: {a: 3602879701896397/2^55, b: 5404319552844595/2^54}\n"
                     "block: {outline: [[0, 0], [a, 0], [a, b], [0, b]]}\n");
}
END_TEST

START_TEST(forms) {
  tp_scene *scene = new_scene("mm");
  DO(tp_scene_set_title(scene, "Teeth", &message));
  DO(tp_scene_set_ellipse(scene, E(8), E(3), E(0.5), &message)); /* replaced */
  DO(tp_scene_set_teeth(scene, 3, E(30), E(120), E(5), TP_LEFT_END_VALLEY, &message));
  DO(tp_scene_set_base_mated(scene, false, &message));
  DO(tp_scene_set_base_beyond(scene, E(0), E(10), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_tilt_towards(scene, false, true, &message));
  DO(tp_scene_set_tilt_angle_deg(scene, E(20), &message));
  expect_same(scene, "topple: 1\ntitle: Teeth\nlength_unit: mm\nblock:\n  teeth: {count: 3, "
                     "width: 30, height: 120, depth: 5, left_end: valley}\n"
                     "base: {mated: true, beyond: {left: 0, right: 10}}\nfriction_angle_deg: 30\n"
                     "tilt: {towards: right, angle_deg: 20}\n");
  scene = new_scene("m");
  DO(tp_scene_set_teeth_over(scene, 4, E(3), E(7), E(0.5), TP_LEFT_END_PEAK, &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  expect_same(scene, "topple: 1\nlength_unit: m\nblock:\n  teeth: {block_width: 3, mean_height: 7, "
                     "amplitude: 0.5, wavelength: 6/4, left_end: peak}\nfriction_angle_deg: 30\n");
  scene = new_scene("m");
  DO(tp_scene_set_teeth(scene, 4, E(3), E(7), E(0.5), TP_LEFT_END_PEAK, &message)); /* replaced */
  DO(tp_scene_set_slab(scene, E(1), E(3), &message));
  DO(tp_scene_set_thickness(scene, E(2), &message));
  expect_same(scene, "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 3}, "
                     "thickness: 2}\n");
  scene = new_scene("m");
  DO(tp_scene_set_ellipse(scene, E(8), E(3), E(0.5), &message));
  expect_same(scene, "topple: 1\nlength_unit: m\n"
                     "block: {ellipse: {width: 8, height: 3, flat: 0.5}}\n");
}
END_TEST

START_TEST(holes_and_parts) {
  static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6}, hole[] = {1, 1, 2, 1, 2, 2, 1, 2};
  static const double other[] = {1, 4, 1.5, 4, 1.5, 5}, part[] = {2.5, 0.5, 3.5, 0.5, 3.5, 5};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_add_hole(scene, tp_coordinates_of(hole, 4), &message));
  DO(tp_scene_add_part(scene, tp_coordinates_of(part, 3), E(20), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25.5), &message));
  DO(tp_scene_add_hole(scene, tp_coordinates_of(other, 3), &message));
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_set_repair(scene, true, &message));
  DO(tp_scene_set_repair(scene, false, &message));
  DO(tp_scene_set_friction_patton(scene, E(25), E(10), &message));
  expect_same(scene,
              "topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [4, 0], [4, 6], [0, 6]]\n"
              "  holes: [[[1, 1], [2, 1], [2, 2], [1, 2]], [[1, 4], [1.5, 4], [1.5, 5]]]\n"
              "  parts: [{outline: [[2.5, 0.5], [3.5, 0.5], [3.5, 5]], unit_weight_kn_m3: 20}]\n"
              "  unit_weight_kn_m3: 25.5\n"
              "friction: {law: patton, basic_angle_deg: 25, roughness_angle_deg: 10}\n");
}
END_TEST

START_TEST(facets) {
  static const double sole[] = {0, 0, 1, 0, 2, 0.5, 4, 0, 4, 6, 0, 6};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_add_friction_facets(scene, 1, 2, E(20), &message));
  DO(tp_scene_set_outline(scene, tp_coordinates_of(sole, 6), &message));
  DO(tp_scene_add_friction_between(scene, E(2), T("9/2"), T("70/3"), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_friction_patton(scene, E(25), E(10), &message));
  expect_same(scene,
              "topple: 1\nlength_unit: m\n"
              "block: {outline: [[0, 0], [1, 0], [2, 0.5], [4, 0], [4, 6], [0, 6]]}\n"
              "friction: {law: patton, basic_angle_deg: 25, roughness_angle_deg: 10, facets: "
              "[{facet: [1, 2], angle_deg: 20}, {x: [2, 9/2], angle_deg: 70/3}]}\n");
}
END_TEST

START_TEST(bases) {
  static const double profile[] = {-1, 0, 2, 0, 2, -1, 5, 0}, ends[] = {0, 0, 1, 0};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(feet, 6), &message));
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(profile, 4), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
#define BLOCK                                                                                      \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock:\n  outline: [[0, 0], [1, 0], "        \
  "[1.5, 0.25], [3, 0.125], [3.5, 4], [0.25, 4.5]]\n"
  char *json = solve(scene, 9);
  tp_scene *read = NULL;
  DO(tp_scene_read_text(&read, BLOCK "base: {profile: [[-1, 0], [2, 0], [2, -1], [5, 0]]}\n", "x",
                        &message));
  expect_equal(json, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_base_rest(scene, true, &message));
  json = solve(scene, 9);
  DO(tp_scene_read_text(&read,
                        BLOCK "base: {profile: [[-1, 0], [2, 0], [2, -1], [5, 0]], place: rest}\n",
                        "x", &message));
  expect_equal(json, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_base_poses(scene, true, &message));
  json = solve(scene, 9);
  DO(tp_scene_read_text(&read,
                        BLOCK "base: {profile: [[-1, 0], [2, 0], [2, -1], [5, 0]], place: all}\n",
                        "x", &message));
  expect_equal(json, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_base_poses(scene, false, &message));
  DO(tp_scene_set_number(scene, "contact.within", E(0.125), &message));
  json = solve(scene, 9);
  DO(tp_scene_read_text(&read,
                        BLOCK "base: {profile: [[-1, 0], [2, 0], [2, -1], [5, 0]]}\n"
                              "contact: {within: 0.125}\n",
                        "x", &message));
  expect_equal(json, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_base_mated(scene, true, &message)); /* the profile is dropped, and the rest */
  DO(tp_scene_set_base_rest(scene, true, &message));
  DO(tp_scene_set_joint_matching(scene, E(0.5), true, &message)); /* replaced */
  DO(tp_scene_set_number(scene, "joint.closure", E(0.125), &message));
  DO(tp_scene_set_number(scene, "joint.shift", E(-0.125), &message));
  json = solve(scene, 9);
  DO(tp_scene_read_text(&read,
                        BLOCK "base: {mated: whole}\njoint: {shift: -0.125, closure: 0.125}\n", "x",
                        &message));
  expect_equal(json, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_base_mated(scene, false, &message)); /* and the shift */
  DO(tp_scene_set_base_between(scene, tp_coordinates_of(ends, 2), &message));
  expect_same(scene, BLOCK "base: {mated: true, between: [[0, 0], [1, 0]]}\n");
  scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(feet, 6), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_base_between(scene, tp_coordinates_of(ends, 2), &message)); /* replaced */
  DO(tp_scene_set_base_bound(scene, TP_BASE_BELOW, E(0.25), &message));
  expect_same(scene, BLOCK "base: {mated: true, between: {below: 0.25}}\n");
  scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(feet, 6), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_base_mated(scene, true, &message));
  expect_same(scene, BLOCK "base: {mated: whole}\n");
}
END_TEST

START_TEST(curves) {
  static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_add_arc_through(scene, E(4), E(6), E(2), E(7), &message));
  DO(tp_scene_add_arc_bulge(scene, E(0), E(6), E(-0.25), &message));
  expect_same(scene, SQUARE "  arcs: [{from: [4, 6], through: [2, 7]}, {from: [0, 6], "
                            "bulge: -0.25}]\n");
  scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(0.5), &message));
  DO(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_RIGHT_END, E(0.25), &message));
  DO(tp_scene_add_rounded_vertex(scene, E(4), E(6), E(1), &message));
#define ROUNDED                                                                                    \
  "corners: [{at: left_end, radius: 0.5}, {at: right_end, radius: 0.25}, {at: [4, 6], radius: 1}]"
  expect_same(scene, SQUARE "  rounded: {" ROUNDED "}\n");
  scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_set_rounding_keeps_mass(scene, true, &message));
  DO(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(0.5), &message));
  expect_same(scene, SQUARE "  rounded: {model: paper, corners: [{at: left_end, radius: 0.5}]}\n");
}
END_TEST

START_TEST(frames) {
  static const double slope[] = {0, 0, 4, 1, 3, 5, -1, 4}, plane[] = {0, 0, 4, 1};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(slope, 4), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_mean_plane(scene, tp_coordinates_of(plane, 2), &message));
#define SLOPE                                                                                      \
  "topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [4, 1], [3, 5], [-1, 4]]}\n"               \
  "friction_angle_deg: 30\n"
  char *one = solve(scene, 9);
  tp_scene *read = NULL;
  DO(tp_scene_read_text(&read, SLOPE "frame: {mean_plane: [[0, 0], [4, 1]]}\n", "x", &message));
  expect_equal(one, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_frame_world(scene, &message));
  one = solve(scene, 9);
  DO(tp_scene_read_text(&read, SLOPE "frame: world\n", "x", &message));
  expect_equal(one, solve(read, 9));
  tp_scene_free(read);
  DO(tp_scene_set_frame_base(scene, &message));
  expect_same(scene, SLOPE "frame: base\n");
}
END_TEST

START_TEST(slope) {
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_slab(scene, E(1.5), E(4), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_slope(scene, E(14.5), TP_TOWARDS_LEFT, &message));
  DO(tp_scene_set_number(scene, "slope.dip_direction_deg", E(135), &message));
  expect_same(scene, "topple: 1\nlength_unit: m\nblock: {slab: {width: 1.5, height: 4}}\n"
                     "friction_angle_deg: 30\n"
                     "slope: {dip_deg: 14.5, towards: left, dip_direction_deg: 135}\n");
}
END_TEST

SUITE(scene_new) {
  Suite *suite = suite_create("scene_new");
  TCase *tests = tcase_create("scenes");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, outlines);
  tcase_add_test(tests, outline_at_once);
  tcase_add_test(tests, exact_numbers);
  tcase_add_test(tests, forms);
  tcase_add_test(tests, holes_and_parts);
  tcase_add_test(tests, facets);
  tcase_add_test(tests, bases);
  tcase_add_test(tests, curves);
  tcase_add_test(tests, frames);
  tcase_add_test(tests, slope);
  suite_add_tcase(suite, tests);
  return suite;
}
