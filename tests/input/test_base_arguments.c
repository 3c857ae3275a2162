/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls that give a scene its base, given and made by rule, and its loads refuse: each
 * names itself and the argument, says what is wrong, and leaves the scene as it was. */

#include "refused_scene.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

#define T(text) tp_exact_text(text)

START_TEST(profiles) {
  static const double line[] = {-1, 0, 5, 0};
  char *text = UNTOUCHED(char);
  REFUSED(tp_scene_profile_csv(NULL, scene, &message), "'text' must not be NULL");
  REFUSED(tp_scene_profile_csv(&text, NULL, &message), "'scene' must not be NULL");
  REFUSED(tp_scene_profile_csv(&text, scene, &message), "the base has no separate profile");
  REFUSED(tp_scene_write_profile("x.csv", NULL, &message), "'scene' must not be NULL");
  REFUSED(tp_scene_write_profile(NULL, scene, &message), "'path' must not be NULL");
  REFUSED(tp_scene_write_profile("x.csv", scene, &message), "the base has no separate profile");
  ck_assert_ptr_eq(text, UNTOUCHED(char));
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(line, 2), &message));
  ck_assert_int_eq(tp_scene_write_profile("/dev/null/x.csv", scene, &message), TP_SYSTEM_FAILED);
  DO(tp_scene_profile_csv(&text, scene, &message));
  ck_assert_str_eq(text, "x,y\n-1,0\n5,0\n");
  free(text);
}
END_TEST

START_TEST(bases) {
  char *before = solve();
  const double leftwards[] = {4, 0, 0, 0};
  REFUSED(tp_scene_set_base_beyond(scene, E(-1), E(0), &message), "cannot end inside the block");
  REFUSED(tp_scene_set_base_between(scene, SQUARE, &message), "in two vertices");
  REFUSED(tp_scene_set_base_bound(scene, (tp_base_bound)3, E(0), &message), "'bound'");
  REFUSED(tp_scene_set_base_profile(scene, tp_coordinates_of(NULL, 3), &message), "'profile'");
  REFUSED(tp_scene_set_slope(scene, E(91), TP_TOWARDS_LEFT, &message), "dip_deg");
  REFUSED(tp_scene_set_slope(scene, E(1), (tp_direction)2, &message), "no such direction");
  REFUSED(tp_scene_set_mean_plane(scene, SQUARE, &message), "by two points on it, not by 4");
  REFUSED(tp_scene_set_mean_plane(scene, tp_coordinates_of(leftwards, 2), &message),
          "from left to right");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(square, 2), &message));
  REFUSED(tp_scene_set_base_beyond(scene, E(1), E(0), &message), "belongs to a mated base");
  REFUSED(tp_scene_set_base_bound(scene, TP_BASE_BELOW, E(0), &message), "belongs to a mated base");
  DO(tp_scene_set_base_mated(scene, true, &message));
  REFUSED(tp_scene_set_base_between(scene, tp_coordinates_of(square, 2), &message),
          "drop one of them");
}
END_TEST

START_TEST(loads) {
  char *before = solve();
  REFUSED(tp_scene_set_water(scene, E(-1), E(10), false, false, &message), "height must not be");
  REFUSED(tp_scene_set_water(scene, E(1), E(-10), false, false, &message), "unit_weight_kn_m3");
  REFUSED(tp_scene_set_water_level(scene, E(NAN), E(10), TP_WATER_BEHIND, TP_WATER_UPLIFT_NONE,
                                   &message),
          "level");
  REFUSED(tp_scene_set_water_level(scene, E(1), E(-10), TP_WATER_BEHIND, TP_WATER_UPLIFT_NONE,
                                   &message),
          "unit_weight_kn_m3");
  REFUSED(tp_scene_set_water_level(scene, E(1), E(10), (tp_water_faces)4, TP_WATER_UPLIFT_NONE,
                                   &message),
          "faces");
  REFUSED(
      tp_scene_set_water_level(scene, E(1), E(10), TP_WATER_BEHIND, (tp_water_uplift)4, &message),
      "uplift");
  REFUSED(tp_scene_set_water_surface(scene, tp_coordinates_of((double[]){0, 0}, 1), E(10),
                                     TP_WATER_BEHIND, TP_WATER_UPLIFT_NONE, &message),
          "two points");
  REFUSED(tp_scene_set_tension_crack_level(scene, E(NAN), &message), "level");
  REFUSED(tp_scene_set_tension_crack_height(scene, E(-1), E(0), &message), "height");
  REFUSED(tp_scene_set_tension_crack_height(scene, E(1), E(-1), &message), "distance");
  REFUSED(tp_scene_set_ice(scene, E(1), E(1), &message), "set that before");
  REFUSED(tp_scene_set_number(scene, "loads.seismic.horizontal", E(NAN), &message), "horizontal");
  REFUSED(tp_scene_set_seismic_direction(scene, (tp_seismic_direction)3, &message), "direction");
  REFUSED(tp_scene_add_pressure(scene, E(0), E(0), E(0), E(1), E(1), E(-1), &message), "last_kpa");
  REFUSED(tp_scene_add_surcharge(scene, E(0), E(0), E(0), E(1), E(-1), &message), "kpa");
  REFUSED(tp_scene_add_anchor(scene, E(0), E(0), E(0), E(-1), false, &message), "force_kn");
  REFUSED(tp_scene_add_bolt(scene, E(0), E(0), E(91), E(1), false, &message), "dip_deg");
  REFUSED(tp_scene_set_bolt_towards(scene, 1, TP_TOWARDS_LEFT, &message), "no bolt of this number");
  REFUSED(tp_scene_set_bolt_length(scene, 0, E(1), &message), "no bolt of this number");
  REFUSED(tp_scene_add_support_pressure(scene, E(0), E(0), E(0), E(1), E(-1), E(1), true, &message),
          "first_kpa");
  REFUSED(tp_scene_set_number(scene, "loads.bond_kpa", E(-1), &message),
          "bond_kpa must not be negative");
  REFUSED(tp_scene_set_number(scene, "loads.cohesion_kpa", E(-1), &message),
          "cohesion_kpa must not be negative");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
}
END_TEST

/* Of a scene of its own, as `scene` is to stay as it is. */
START_TEST(bolts) {
  tp_scene *own = NULL;
  DO(tp_scene_new(&own, "m", &message));
  DO(tp_scene_add_bolt(own, E(0), E(1), E(15), E(50), false, &message));
  REFUSED(tp_scene_set_bolt_towards(own, 1, (tp_direction)2, &message), "no such direction");
  REFUSED(tp_scene_set_bolt_spacing(own, 1, E(0), &message), "spacing must be above zero");
  REFUSED(tp_scene_set_bolt_capacity_kn(own, 1, E(-1), &message), "capacity_kn must be above");
  REFUSED(tp_scene_set_bolt_rows(own, 1, 0, E(0), E(-1), &message), "rows must be a whole");
  tp_scene_free(own);
}
END_TEST

static char *csv_of(void) {
  char *text = NULL;
  DO(tp_scene_profile_csv(&text, scene, &message));
  return text;
}

START_TEST(teeth) {
  char *before = solve();
  tp_base_teeth_options o = tp_base_teeth_options_default();
#define TEETH tp_scene_set_base_teeth(scene, &o, &message)
  REFUSED(tp_scene_set_base_teeth(scene, NULL, &message), "'options' must not be NULL");
  REFUSED(TEETH, "tp_scene_set_base_teeth: count must be a whole number of teeth, at least 1");
  o.count = 4;
  REFUSED(TEETH, "wavelength must be above zero, not 0");
  o.wavelength = E(NAN);
  REFUSED(TEETH, "wavelength must be a finite number, not nan");
  o.wavelength = T("1/3");
  REFUSED(TEETH, "amplitude must be above zero, not 0");
  o.amplitude = E(1);
  o.skew = E(1);
  REFUSED(TEETH, "skew must lie between -0.9 and 0.9; it is 1");
  o.skew = E(0.5);
  o.skew_scatter = E(0.5);
  REFUSED(TEETH, "together at most 0.9");
  o.skew_scatter = E(0);
  o.wavelength_scatter = E(0.95);
  REFUSED(TEETH, "wavelength must lie between 0 and 0.9");
  o.wavelength_scatter = E(0);
  o.amplitude_scatter = T("x");
  REFUSED(TEETH, "amplitude_scatter: 'x'");
  o.amplitude_scatter = E(0);
  o.start_y = E(INFINITY);
  REFUSED(TEETH, "start_y must be a finite number");
  o.start_y = E(0);
  o.seed = -1;
  REFUSED(TEETH, "seed must not be negative");
  o.seed = 0;
  o.left_end = (tp_left_end)2;
  REFUSED(TEETH, "left_end must be valley or peak");
  o.left_end = TP_LEFT_END_PEAK;
  o.size++;
  REFUSED(TEETH, "the size of 'options'");
  o.size = 0;
  REFUSED(TEETH, "the size of 'options'");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
  o.size = sizeof o;
  DO(TEETH);
}
END_TEST

START_TEST(self_affine) {
  char *before = solve();
  tp_base_self_affine_options o = tp_base_self_affine_options_default();
#define ROUGH tp_scene_set_base_self_affine(scene, &o, &message)
  REFUSED(tp_scene_set_base_self_affine(scene, NULL, &message), "'options' must not be NULL");
  REFUSED(ROUGH, "tp_scene_set_base_self_affine: length must be above zero, not 0");
  o.length = E(40);
  REFUSED(ROUGH, "step must be above zero");
  o.step = T("0.3");
  REFUSED(ROUGH, "a whole number of steps, from 8 to 499999; it is 400/3");
  o.step = E(0.5);
  REFUSED(ROUGH, "hurst must lie strictly between 0 and 1; it is 0");
  o.hurst = E(0.75);
  REFUSED(ROUGH, "rms_height must be above zero");
  o.by = TP_ROUGHNESS_JRC;
  o.roughness = E(21);
  REFUSED(ROUGH, "jrc must lie between 0 and 20; it is 21");
  o.roughness = E(8);
  o.by = (tp_roughness_by)3;
  REFUSED(ROUGH, "'by' must be the RMS height, Z2 or JRC");
  o.by = TP_ROUGHNESS_JRC;
  o.shortest = E(0.75);
  REFUSED(ROUGH, "wavelengths go from 'shortest'");
  o.shortest = E(20);
  o.longest = E(20.125);
  REFUSED(ROUGH, "no wave of the profile's period");
  o.shortest = o.longest = E(0);
  o.seed = LLONG_MIN;
  REFUSED(ROUGH, "seed must not be negative");
  o.size = 3;
  REFUSED(ROUGH, "the size of 'options'");
  REFUSED(tp_scene_set_base_jrc_profile(scene, 0, &message), "1 to 10; it is 0");
  REFUSED(tp_scene_set_base_jrc_profile(scene, 11, &message),
          "tp_scene_set_base_jrc_profile: jrc_profile is the number of a standard profile");
  char *after = solve();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
}
END_TEST

/* What changes a profile needs one, and leaves it as it was where it cannot. */
START_TEST(changes) {
  static const double line[] = {-1, 0, 2, 1, 5, 0}, level[] = {-1, 0, 5, 0},
                      back[] = {0, 0, 3, 1, 2, 2};
#define NOISE(deviation, seed) tp_scene_set_base_noise(scene, deviation, seed, &message)
#define SCALED(by, value) tp_scene_set_base_scaled(scene, by, value, &message)
#define WORN(wear, depth) tp_scene_set_base_worn(scene, wear, depth, &message)
  REFUSED(NOISE(E(1), 1), "tp_scene_set_base_noise: noise is of a base profile");
  REFUSED(SCALED(TP_ROUGHNESS_Z2, E(1)), "set its profile first");
  REFUSED(WORN(TP_WEAR_CUT, E(1)), "set its profile first");
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(line, 3), &message));
  char *before = csv_of();
  REFUSED(NOISE(E(0), 1), "deviation must be above zero");
  REFUSED(NOISE(E(1), -1), "seed must not be negative");
  REFUSED(SCALED(TP_ROUGHNESS_RMS_HEIGHT, E(0)), "rms_height must be above zero");
  REFUSED(SCALED(TP_ROUGHNESS_Z2, E(0)), "z2 must lie between 0.000001 and 1000");
  REFUSED(SCALED(TP_ROUGHNESS_JRC, E(-1)), "jrc must lie between 0 and 20");
  REFUSED(SCALED((tp_roughness_by)-1, E(1)), "'by' must be");
  REFUSED(WORN(TP_WEAR_CUT, E(1)), "'cut' removes all of the roughness");
  REFUSED(WORN(TP_WEAR_ROUNDED, E(0)), "rounded must be above zero");
  REFUSED(WORN((tp_wear)3, E(1)), "'wear' must be cut, rounded or abraded");
  char *after = csv_of();
  ck_assert_str_eq(before, after);
  free(before);
  free(after);
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(level, 2), &message));
  REFUSED(SCALED(TP_ROUGHNESS_Z2, E(1)), "the profile is level");
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(back, 3), &message));
  REFUSED(SCALED(TP_ROUGHNESS_JRC, E(1)), "folds back or steps upright");
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(line, 1), &message));
  REFUSED(NOISE(E(1), 1), "a base profile needs at least two points");
}
END_TEST

/* Many blocks: each by its number, which must be there; nothing of one block stands beside them. */
START_TEST(blocks) {
  tp_block_system *system = UNTOUCHED(tp_block_system);
  const tp_solve_options options = tp_solve_options_default();
#define SYSTEM tp_solve_block_system(&system, scene, &options, &message)
  REFUSED(SYSTEM, "this scene is of one block");
  tear_down();
  DO(tp_scene_new(&scene, "m", &message));
  REFUSED(tp_scene_add_block(scene, SQUARE, "", true, &message), "a text of 1 to 60 bytes");
  REFUSED(tp_scene_add_block(scene, tp_coordinates_of(NULL, 3), "a", true, &message), "outline");
  REFUSED(tp_scene_add_joint(scene, 1, 2, &message), "there is no block of this number");
  DO(tp_scene_add_block(scene, SQUARE, "a", false, &message));
  REFUSED(tp_scene_add_joint(scene, 1, 1, &message), "a joint is between two blocks");
  REFUSED(tp_scene_add_joint(scene, 0, 1, &message), "the scene has 1");
  REFUSED(tp_scene_set_joint_tension_kpa(scene, 1, E(1), &message), "there is no joint of this");
  REFUSED(tp_scene_set_block_unit_weight_kn_m3(scene, 1, E(0), &message),
          "tp_scene_set_block_unit_weight_kn_m3:1: unit_weight_kn_m3 must be above zero");
  REFUSED(tp_scene_add_block_hole(scene, 2, SQUARE, &message), "there is no block of this number");
  REFUSED(tp_scene_set_bolt_into(scene, 1, 1, &message), "there is no bolt of this number");
  REFUSED(tp_scene_set_load_block(scene, (tp_placed_load)9, 1, 1, &message), "no such load");
  REFUSED(tp_scene_set_load_block(scene, TP_PLACED_FORCE, 1, 1, &message), "there is no load of");
  REFUSED(tp_scene_set_support(scene, 2, E(0), E(0), &message), "there is no block of this number");
  DO(tp_scene_add_block(scene, SQUARE, "a", true, &message));
  REFUSED(SYSTEM, "tp_scene_add_block:2: two blocks are named 'a', the first is block 1");
  tear_down();
  DO(tp_scene_new(&scene, "m", &message));
  DO(tp_scene_add_block(scene, SQUARE, NULL, true, &message));
  tp_solution *solution = UNTOUCHED(tp_solution);
  REFUSED(tp_solve(&solution, scene, &options, &message), "which tp_solve_block_system takes");
  DO(tp_scene_set_water(scene, E(1), E(10), false, false, &message));
  REFUSED(SYSTEM, "tp_scene_set_water: 'height' is of one block on its base");
  DO(tp_scene_set_base_mated(scene, false, &message));
  REFUSED(SYSTEM, "tp_scene_set_base_mated: this is of a scene of one block");
  DO(tp_scene_set_slab(scene, E(1), E(1), &message));
  REFUSED(SYSTEM, "tp_scene_set_slab: this is of a scene of one block");
  ck_assert_ptr_eq(system, UNTOUCHED(tp_block_system));
  REFUSED(tp_solve(&solution, scene, &options, &message), "or many by tp_scene_add_block");
}
END_TEST

SUITE(base_arguments) {
  Suite *suite = suite_create("base_arguments");
  TCase *tests = tcase_create("bases");
  tcase_add_checked_fixture(tests, set_up, tear_down);
  tcase_add_test(tests, profiles);
  tcase_add_test(tests, bases);
  tcase_add_test(tests, loads);
  tcase_add_test(tests, bolts);
  tcase_add_test(tests, blocks);
  tcase_add_test(tests, teeth);
  tcase_add_test(tests, self_affine);
  tcase_add_test(tests, changes);
  suite_add_tcase(suite, tests);
  return suite;
}
