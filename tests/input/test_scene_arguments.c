/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls that build a scene refuse: each names itself and the argument, says what is wrong,
 * and leaves the scene as it was. */

#include "refused_scene.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#define T(text) tp_exact_text(text)

START_TEST(new_scenes) {
  tp_scene *made = UNTOUCHED(tp_scene);
  REFUSED(tp_scene_new(NULL, "m", &message), "tp_scene_new: 'scene' must not be NULL");
  REFUSED(tp_scene_new(&made, NULL, &message), "tp_scene_new: 'length_unit' must not be NULL");
  REFUSED(tp_scene_new(&made, "yd", &message),
          "tp_scene_new: length_unit must be one of mm, cm, m, km, in, ft");
  REFUSED(tp_scene_new(&made, "", &message), "length_unit must be one of");
  ck_assert_int_eq(tp_scene_new(&made, "", NULL), TP_BAD_INPUT);
  ck_assert_ptr_eq(made, UNTOUCHED(tp_scene));
}
END_TEST

/* Every call without a scene, and with one that was read. */
static void refuse_all(tp_scene *own, const char *why) {
  const tp_coordinates s = SQUARE;
  const tp_base_teeth_options teeth = tp_base_teeth_options_default();
  const tp_base_self_affine_options rough = tp_base_self_affine_options_default();
  REFUSED(tp_scene_set_title(own, "x", &message), why);
  REFUSED(tp_scene_set_outline(own, s, &message), why);
  REFUSED(tp_scene_set_slab(own, E(1), E(1), &message), why);
  REFUSED(tp_scene_set_teeth(own, 1, E(1), E(1), E(1), TP_LEFT_END_PEAK, &message), why);
  REFUSED(tp_scene_set_teeth_over(own, 1, E(1), E(1), E(1), TP_LEFT_END_PEAK, &message), why);
  REFUSED(tp_scene_set_ellipse(own, E(3), E(1), E(1), &message), why);
  REFUSED(tp_scene_add_hole(own, s, &message), why);
  REFUSED(tp_scene_add_part(own, s, E(1), &message), why);
  REFUSED(tp_scene_add_arc_through(own, E(1), E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_add_arc_bulge(own, E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_add_rounded_end(own, TP_UNDERSIDE_LEFT_END, E(1), &message), why);
  REFUSED(tp_scene_add_rounded_vertex(own, E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_set_rounding_keeps_mass(own, true, &message), why);
  REFUSED(tp_scene_set_repair(own, true, &message), why);
  REFUSED(tp_scene_set_result_unit(own, "kN", &message), why);
  REFUSED(tp_scene_set_thickness(own, E(1), &message), why);
  REFUSED(tp_scene_set_number(own, "block.thickness", E(1), &message), why);
  REFUSED(tp_scene_set_unit_weight_kn_m3(own, E(20), &message), why);
  REFUSED(tp_scene_set_base_mated(own, true, &message), why);
  REFUSED(tp_scene_set_base_rest(own, true, &message), why);
  REFUSED(tp_scene_set_base_poses(own, true, &message), why);
  REFUSED(tp_scene_set_joint_matching(own, E(0.5), true, &message), why);
  REFUSED(tp_scene_set_friction_is_apparent(own, true, &message), why);
  REFUSED(tp_scene_set_base_profile(own, s, &message), why);
  REFUSED(tp_scene_set_base_teeth(own, &teeth, &message), why);
  REFUSED(tp_scene_set_base_self_affine(own, &rough, &message), why);
  REFUSED(tp_scene_set_base_jrc_profile(own, 1, &message), why);
  REFUSED(tp_scene_set_base_noise(own, E(1), 1, &message), why);
  REFUSED(tp_scene_set_base_scaled(own, TP_ROUGHNESS_Z2, E(1), &message), why);
  REFUSED(tp_scene_set_base_worn(own, TP_WEAR_CUT, E(1), &message), why);
  REFUSED(tp_scene_set_base_beyond(own, E(1), E(1), &message), why);
  REFUSED(tp_scene_set_base_between(own, tp_coordinates_of(square, 2), &message), why);
  REFUSED(tp_scene_set_base_bound(own, TP_BASE_BELOW, E(1), &message), why);
  REFUSED(tp_scene_set_friction_angle_deg(own, E(1), &message), why);
  REFUSED(tp_scene_set_friction_patton(own, E(1), E(1), &message), why);
  REFUSED(tp_scene_set_friction_barton(own, E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_set_friction_barton_test(own, E(1), E(2), E(1), E(1), &message), why);
  REFUSED(tp_scene_set_friction_barton_roughness(own, E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_add_friction_facets(own, 1, 1, E(1), &message), why);
  REFUSED(tp_scene_add_friction_between(own, E(0), E(1), E(1), &message), why);
  REFUSED(tp_scene_set_tilt_towards(own, true, true, &message), why);
  REFUSED(tp_scene_set_tilt_angle_deg(own, E(1), &message), why);
  REFUSED(tp_scene_set_frame_base(own, &message), why);
  REFUSED(tp_scene_set_frame_world(own, &message), why);
  REFUSED(tp_scene_set_slope(own, E(1), TP_TOWARDS_LEFT, &message), why);
  REFUSED(tp_scene_set_mean_plane(own, tp_coordinates_of(square, 2), &message), why);
  REFUSED(tp_scene_set_seismic_direction(own, TP_SEISMIC_BOTH, &message), why);
  REFUSED(tp_scene_set_water(own, E(1), E(10), false, false, &message), why);
  REFUSED(
      tp_scene_set_water_level(own, E(1), E(10), TP_WATER_BEHIND, TP_WATER_UPLIFT_NONE, &message),
      why);
  REFUSED(tp_scene_set_water_surface(own, tp_coordinates_of(square, 2), E(10), TP_WATER_BEHIND,
                                     TP_WATER_UPLIFT_NONE, &message),
          why);
  REFUSED(tp_scene_set_tension_crack_level(own, E(1), &message), why);
  REFUSED(tp_scene_set_tension_crack_height(own, E(1), E(0), &message), why);
  REFUSED(tp_scene_set_ice(own, E(1), E(1), &message), why);
  REFUSED(tp_scene_add_pressure(own, E(1), E(1), E(1), E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_add_surcharge(own, E(1), E(1), E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_add_anchor(own, E(1), E(1), E(1), E(1), false, &message), why);
  REFUSED(tp_scene_add_support_pressure(own, E(1), E(1), E(1), E(1), E(1), E(1), true, &message),
          why);
  REFUSED(tp_scene_add_bolt(own, E(1), E(1), E(1), E(1), false, &message), why);
  REFUSED(tp_scene_set_bolt_towards(own, 1, TP_TOWARDS_LEFT, &message), why);
  REFUSED(tp_scene_set_bolt_length(own, 1, E(1), &message), why);
  REFUSED(tp_scene_set_bolt_capacity_kn(own, 1, E(1), &message), why);
  REFUSED(tp_scene_set_bolt_spacing(own, 1, E(1), &message), why);
  REFUSED(tp_scene_set_bolt_rows(own, 1, 2, E(0), E(1), &message), why);
  REFUSED(tp_scene_add_block(own, s, "x", true, &message), why);
  REFUSED(tp_scene_set_block_unit_weight_kn_m3(own, 1, E(1), &message), why);
  REFUSED(tp_scene_add_block_hole(own, 1, s, &message), why);
  REFUSED(tp_scene_add_block_part(own, 1, s, E(1), &message), why);
  REFUSED(tp_scene_add_joint(own, 1, 2, &message), why);
  REFUSED(tp_scene_set_joint_friction_angle_deg(own, 1, E(1), &message), why);
  REFUSED(tp_scene_set_joint_cohesion_kpa(own, 1, E(1), &message), why);
  REFUSED(tp_scene_set_joint_tension_kpa(own, 1, E(1), &message), why);
  REFUSED(tp_scene_add_bolt_to(own, E(1), E(1), E(2), E(2), E(1), false, &message), why);
  REFUSED(tp_scene_add_force(own, E(1), E(1), E(1), E(1), &message), why);
  REFUSED(tp_scene_set_bolt_into(own, 1, 1, &message), why);
  REFUSED(tp_scene_set_load_block(own, TP_PLACED_BOLT, 1, 1, &message), why);
  REFUSED(tp_scene_set_support(own, 1, E(1), E(1), &message), why);
}

START_TEST(scenes) {
  refuse_all(NULL, "'scene' must not be NULL");
  tp_scene *read = NULL;
  DO(tp_scene_read_text(&read, "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n",
                        "x", &message));
  refuse_all(read, "this scene was read from a file");
  tp_scene_free(read);
}
END_TEST

START_TEST(numbers) {
  char *before = solve();
#define ANGLE(number) tp_scene_set_friction_angle_deg(scene, number, &message)
  REFUSED(ANGLE(E(NAN)),
          "tp_scene_set_friction_angle_deg: angle_deg must be a finite number, not nan");
  REFUSED(ANGLE(E(INFINITY)), "not inf");
  REFUSED(ANGLE(E(-INFINITY)), "not -inf");
  REFUSED(ANGLE(E(5e-324)), "angle_deg is outside the range of 1e-308 to 1e308");
  REFUSED(ANGLE(E(1.7e308)), "angle_deg is outside the range");
  REFUSED(ANGLE(E(90)), "angle_deg must lie in [0°, 90°)");
  REFUSED(ANGLE(E(-1e-300)), "angle_deg must lie in [0°, 90°)");
  REFUSED(ANGLE(T(NULL)), "angle_deg must be a finite number");
  REFUSED(ANGLE(T("")), "angle_deg: ''");
  REFUSED(ANGLE(T("12,5")), "write a decimal, as 0.1, or a fraction, as 1/3");
  REFUSED(ANGLE(T("1/0")), "divides by zero");
  REFUSED(ANGLE(T("30 ")), "angle_deg: '30 '");
  REFUSED(ANGLE(T("nan")), "angle_deg: 'nan'");
  REFUSED(ANGLE(T("1e999")), "angle_deg");
  ck_assert_int_eq(tp_scene_set_friction_angle_deg(scene, E(90), NULL), TP_BAD_INPUT);
  REFUSED(tp_scene_set_tilt_angle_deg(scene, T("90.01"), &message),
          "tp_scene_set_tilt_angle_deg: angle_deg must lie in [0°, 90°]");
  REFUSED(tp_scene_set_thickness(scene, E(0), &message), "thickness must be above zero, not 0");
  REFUSED(tp_scene_set_number(scene, "block.thickness", E(0), &message),
          "thickness must be above zero, not 0");
  REFUSED(tp_scene_set_number(scene, "block.slab.width", E(1), &message),
          "'block.slab.width' is no key of a number that stands by itself");
  REFUSED(tp_scene_set_number(scene, NULL, E(1), &message), "'key' must not be NULL");
  REFUSED(tp_scene_set_unit_weight_kn_m3(scene, E(0), &message),
          "unit_weight_kn_m3 must be above zero; a void is a hole");
  REFUSED(tp_scene_set_friction_patton(scene, E(50), E(40), &message), "must lie below 90°");
  REFUSED(tp_scene_set_friction_barton(scene, E(30), E(101), E(1), &message),
          "jrc must lie in [0, 100]");
  REFUSED(tp_scene_set_friction_barton(scene, E(30), E(1), E(0), &message),
          "jcs_mpa must be above zero");
  REFUSED(tp_scene_set_friction_barton_test(scene, E(30), E(29), E(1), E(1), &message),
          "slides at residual_angle_deg or above");
  REFUSED(tp_scene_set_friction_barton_test(scene, E(30), E(31), E(1000), E(1), &message),
          "must be below jcs_mpa");
  REFUSED(tp_scene_set_friction_barton_roughness(scene, E(30), E(90), E(1), &message),
          "roughness_angle_deg must lie in");
  REFUSED(tp_scene_add_friction_facets(scene, 0, 1, E(20), &message), "there is no facet 0");
  REFUSED(tp_scene_add_friction_facets(scene, 1, SIZE_MAX, E(20), &message), "there is no facet");
  REFUSED(tp_scene_add_friction_facets(scene, 2, 1, E(20), &message), "before the last");
  REFUSED(tp_scene_add_friction_facets(scene, 1, 1, E(90), &message), "angle_deg must lie in");
  REFUSED(tp_scene_add_friction_between(scene, E(1), E(1), E(20), &message),
          "the second must be the larger");
  REFUSED(tp_scene_add_friction_between(scene, E(NAN), E(1), E(20), &message), "x0");
  REFUSED(tp_scene_set_tilt_towards(scene, false, false, &message), "'left' and 'right'");
  REFUSED(tp_scene_set_title(scene, NULL, &message), "'title' must not be NULL");
  REFUSED(tp_scene_set_result_unit(scene, NULL, &message), "'name' must not be NULL");
  REFUSED(tp_scene_set_result_unit(scene, "stone", &message),
          "'stone' is not a unit for reports; known are: mm, cm");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
}
END_TEST

START_TEST(outlines) {
  char *before = solve();
  double bad[] = {0, 0, 4, 0, 4, NAN, 0, 6};
  const char *texts[] = {"0", "0", "4", "x", "4", NULL};
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_of(bad, 4), &message),
          "tp_scene_set_outline: y of point 3 of outline must be a finite number, not nan");
  bad[5] = 1e-320;
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_of(bad, 4), &message),
          "y of point 3 of outline is outside the range");
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_of(NULL, 4), &message),
          "the coordinates of 'outline' must not be NULL");
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_text(NULL, 0), &message), "must not be NULL");
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_of(square, 200000000), &message),
          "at most 100 million");
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_text(texts, 3), &message),
          "y of point 2 of outline: 'x'");
  texts[3] = "0";
  REFUSED(tp_scene_set_outline(scene, tp_coordinates_text(texts, 3), &message),
          "y of point 3 of outline must not be NULL");
  REFUSED(tp_scene_add_hole(scene, tp_coordinates_of(NULL, 4), &message), "tp_scene_add_hole: ");
  REFUSED(tp_scene_add_part(scene, tp_coordinates_of(NULL, 4), E(20), &message), "'outline'");
  REFUSED(tp_scene_add_part(scene, SQUARE, E(-20), &message), "a void is a hole");
  REFUSED(tp_scene_set_slab(scene, E(0), E(1), &message), "width must be above zero, not 0");
  REFUSED(tp_scene_set_slab(scene, E(1), E(-1), &message), "height must be above zero, not -1");
  REFUSED(tp_scene_set_teeth(scene, 0, E(1), E(1), E(1), TP_LEFT_END_PEAK, &message),
          "count must be a whole number of teeth, at least 1; it is 0");
  REFUSED(tp_scene_set_teeth(scene, 20000000, E(1), E(1), E(1), TP_LEFT_END_PEAK, &message),
          "at most 500 000 teeth");
  REFUSED(tp_scene_set_teeth(scene, 2, E(1), E(1), E(-1), TP_LEFT_END_PEAK, &message),
          "depth must not be negative");
  REFUSED(tp_scene_set_teeth(scene, 2, E(1), E(1), E(1), (tp_left_end)7, &message),
          "left_end must be valley or peak");
  REFUSED(tp_scene_set_teeth_over(scene, 2, E(1), E(1), E(2), TP_LEFT_END_PEAK, &message),
          "less than twice mean_height");
  REFUSED(tp_scene_set_ellipse(scene, E(3), E(1), E(3), &message), "narrower than the ellipse");
  REFUSED(tp_scene_add_arc_bulge(scene, E(0), E(0), E(0), &message), "leave the arc out");
  REFUSED(tp_scene_add_arc_through(scene, E(0), E(NAN), E(0), E(0), &message), "from_y");
  REFUSED(tp_scene_add_rounded_end(scene, (tp_underside_end)2, E(1), &message), "'at'");
  REFUSED(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(-1), &message),
          "radius must not be negative");
  REFUSED(tp_scene_add_rounded_vertex(scene, E(0), E(0), E(-1), &message), "radius");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
}
END_TEST

/* One call for an outline: its own pointers, then what the calls that it stands for refuse. */
START_TEST(outlines_at_once) {
  tp_solution *solution = UNTOUCHED(tp_solution);
#define AT_ONCE(xy, count, friction, tilt)                                                         \
  tp_solve_outline(&solution, xy, count, "m", friction, tilt, &message)
  REFUSED(tp_solve_outline(NULL, square, 4, "m", 30, 20, &message),
          "tp_solve_outline: 'solution' must not be NULL");
  REFUSED(tp_solve_outline(&solution, square, 4, NULL, 30, 20, &message), "'length_unit'");
  REFUSED(AT_ONCE(NULL, 4, 30, 20), "tp_solve_outline: 'outline' must not be NULL");
  REFUSED(tp_solve_outline(&solution, square, 4, "yd", 30, 20, &message), "one of mm, cm, m");
  REFUSED(AT_ONCE(square, 0, 30, 20), "tp_scene_set_outline");
  REFUSED(AT_ONCE(square, 2, 30, 20), "tp_scene_set_outline");
  REFUSED(AT_ONCE(square, SIZE_MAX / 2 + 2, 30, 20), "at most 100 million");
  REFUSED(AT_ONCE(square, 4, 90, 20), "tp_scene_set_friction_angle_deg: angle_deg must lie");
  REFUSED(AT_ONCE(square, 4, NAN, 20), "tp_scene_set_friction_angle_deg: angle_deg must be");
  REFUSED(AT_ONCE(square, 4, 30, -1), "tp_scene_set_tilt_angle_deg: angle_deg must lie");
  REFUSED(AT_ONCE(square, 4, 30, INFINITY), "tp_scene_set_tilt_angle_deg: angle_deg must be");
  ck_assert_int_eq(tp_solve_outline(&solution, square, 4, "m", 90, 20, NULL), TP_BAD_INPUT);
  ck_assert_ptr_eq(solution, UNTOUCHED(tp_solution));
}
END_TEST

/* What needs several calls is told where the scene is used, by the name of the call. */
START_TEST(whole_scenes) {
  tp_solution *solution = UNTOUCHED(tp_solution);
  tp_derivation *derivation = UNTOUCHED(tp_derivation);
  const tp_derive_options derive = tp_derive_options_default();
  tp_family *family = UNTOUCHED(tp_family);
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *empty = NULL;
#define SOLVE(own) tp_solve(&solution, own, &options, &message)
  DO(tp_scene_new(&empty, "m", &message));
  REFUSED(SOLVE(empty), "the scene has no block");
  tp_scene_free(empty);
  REFUSED(tp_derive(&derivation, scene, &derive, &message), "built in memory");
  REFUSED(tp_derive_family(&family, scene, TP_NOTATION_TEXT, &message), "built in memory");
  DO(tp_scene_set_number(scene, "loads.bond_kpa", E(1), &message));
  REFUSED(SOLVE(scene), "loads.bond_kpa: loads are weighed against the block");
  DO(tp_scene_set_friction_barton(scene, E(30), E(8), E(100), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_add_arc_bulge(scene, E(0), E(0), E(1), &message));
  DO(tp_scene_set_slab(scene, E(1), E(2), &message));
  REFUSED(SOLVE(scene), "tp_scene_add_arc_bulge:1: arcs belong to an 'outline' of vertices");
  DO(tp_scene_set_ellipse(scene, E(8), E(3), E(1), &message));
  REFUSED(SOLVE(scene), "tp_scene_set_ellipse: an ellipse takes no holes");
  DO(tp_scene_set_outline(scene, SQUARE, &message));
  DO(tp_scene_set_repair(scene, true, &message));
  REFUSED(SOLVE(scene), "tp_scene_set_repair: an outline with arcs cannot be repaired");
  tear_down();
  set_up();
  DO(tp_scene_set_friction_barton(scene, E(30), E(8), E(100), &message));
  REFUSED(SOLVE(scene), "tp_scene_set_friction_barton: the law barton depends");
  DO(tp_scene_add_part(scene, SQUARE, E(20), &message));
  REFUSED(SOLVE(scene), "tp_scene_add_part:1: parts of another density need");
  tear_down();
  set_up();
  DO(tp_scene_add_friction_facets(scene, 2, 2, E(20), &message));
  REFUSED(SOLVE(scene), "tp_scene_add_friction_facets:1: there is no facet 2: the base has 1");
  tear_down();
  set_up();
  DO(tp_scene_add_friction_facets(scene, 1, 1, E(20), &message));
  DO(tp_scene_add_friction_between(scene, E(-1), E(5), E(25), &message));
  REFUSED(SOLVE(scene), "tp_scene_add_friction_between:2: facet 1 of the base is given");
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_set_friction_barton(scene, E(30), E(8), E(100), &message));
  REFUSED(SOLVE(scene), "tp_scene_add_friction_facets:1: the law barton is for the contact");
  static const double crossed[] = {0, 0, 4, 6, 4, 0, 0, 6};
  tear_down();
  set_up();
  DO(tp_scene_set_outline(scene, tp_coordinates_of(crossed, 4), &message));
  REFUSED(SOLVE(scene), "tp_scene_set_outline:");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 2), &message));
  REFUSED(SOLVE(scene), "tp_scene_set_outline");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 0), &message));
  REFUSED(SOLVE(scene), "tp_scene_set_outline");
  DO(tp_scene_set_outline(scene, SQUARE, &message));
  DO(tp_scene_add_hole(scene, tp_coordinates_of(square, 0), &message));
  REFUSED(SOLVE(scene), "tp_scene_add_hole:1");
  ck_assert_ptr_eq(solution, UNTOUCHED(tp_solution));
  ck_assert_ptr_eq(derivation, UNTOUCHED(tp_derivation));
  ck_assert_ptr_eq(family, UNTOUCHED(tp_family));
}
END_TEST

SUITE(scene_arguments) {
  Suite *suite = suite_create("scene_arguments");
  TCase *tests = tcase_create("scenes");
  tcase_add_checked_fixture(tests, set_up, tear_down);
  tcase_add_test(tests, new_scenes);
  tcase_add_test(tests, scenes);
  tcase_add_test(tests, numbers);
  tcase_add_test(tests, outlines);
  tcase_add_test(tests, outlines_at_once);
  tcase_add_test(tests, whole_scenes);
  suite_add_tcase(suite, tests);
  return suite;
}
