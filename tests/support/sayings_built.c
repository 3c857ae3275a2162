/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes built in memory. Every call that builds, from doubles and from texts with a decimal point,
 * which a program whose decimals have a comma gives too. */

#include "sayings.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#define E(number) tp_exact_of(number)
#define T(text) tp_exact_text(text)
#define SAY(call) note_status(s, call, &message)

static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
/* Two feet, and a hollow between them, on a slope of a tenth. */
static const char *const feet[] = {"0", "0",  "1",   "1e-1", "1.5",  "4/5",
                                   "3", ".3", "3.5", "4.35", "0.25", "4.75"};

static tp_scene *begin(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  SAY(tp_scene_new(&scene, "m", &message));
  return scene;
}

static tp_scene *begin_square(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = begin(s);
  if (scene == NULL) return NULL;
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  SAY(tp_scene_set_unit_weight_kn_m3(scene, E(25.5), &message));
  SAY(tp_scene_set_friction_angle_deg(scene, T("100/3"), &message));
  SAY(tp_scene_set_tilt_towards(scene, true, false, &message));
  SAY(tp_scene_set_tilt_angle_deg(scene, T("10.5"), &message));
  return scene;
}

/* Solved to the digits of a double, and to more. */
static void say_scene_built(sayings *s, const tp_scene *scene) {
  say_solved(s, scene, false, 9, false);
  say_solved(s, scene, false, 30, false);
}

void say_built(sayings *s) {
  static const double hole[] = {1, 1, 2, 1, 2, 2, 1, 2};
  static const char *const part[] = {"2.5", "0.5", "7/2", "0.5", "7/2", "5"};
  tp_message message = {.text = ""};
  tp_scene *scene = begin_square(s);
  if (scene == NULL) return;
  SAY(tp_scene_set_title(scene, "Built, 1,5 by 1.5", &message));
  SAY(tp_scene_add_hole(scene, tp_coordinates_of(hole, 4), &message));
  SAY(tp_scene_add_part(scene, tp_coordinates_text(part, 3), T("20.25"), &message));
  SAY(tp_scene_set_thickness(scene, E(0.7), &message));
  SAY(tp_scene_set_number(scene, "block.thickness", T("0.75"), &message));
  SAY(tp_scene_set_number(scene, "block.thicknes", T("0.75"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_friction_patton(scene, E(25.1), T("10.2"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_friction_barton(scene, E(28.5), E(8.1), E(120.3), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_friction_barton_test(scene, E(28), T("55.5"), E(2.5), E(120), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_friction_barton_roughness(scene, E(28), E(12.5), E(120), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_friction_angle_deg(scene, E(31.5), &message));
  SAY(tp_scene_add_friction_facets(scene, 1, 1, T("20.5"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_add_friction_between(scene, E(-0.5), T("1/3"), E(20), &message));
  say_scene_built(s, scene);
  tp_scene_free(scene);
}

static void say_forms(sayings *s, tp_scene *scene) {
  tp_message message = {.text = ""};
  SAY(tp_scene_set_teeth(scene, 3, E(3.1), E(12.25), T("0.51"), TP_LEFT_END_VALLEY, &message));
  SAY(tp_scene_set_base_mated(scene, false, &message));
  SAY(tp_scene_set_base_beyond(scene, E(0), E(10.5), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_base_mated(scene, true, &message));
  SAY(tp_scene_set_teeth_over(scene, 4, E(3.3), E(7), E(0.5), TP_LEFT_END_PEAK, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_ellipse(scene, E(8.5), T("3.25"), E(0.5), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_slab(scene, T("1.1"), E(3.3), &message));
  SAY(tp_scene_set_result_unit(scene, "kip ft", &message));
  SAY(tp_scene_set_result_unit(scene, "psf", &message));
  SAY(tp_scene_set_result_unit(scene, "stone", &message));
  SAY(tp_scene_set_repair(scene, true, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_repair(scene, false, &message));
}

static void say_bases(sayings *s, tp_scene *scene) {
  static const double plane[] = {0, 0, 1, 0.125}, profile[] = {-1, 0, 2, 0, 2, -1, 5.5, 0};
  tp_message message = {.text = ""};
  SAY(tp_scene_set_outline(scene, tp_coordinates_text(feet, 6), &message));
  SAY(tp_scene_set_frame_world(scene, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_mean_plane(scene, tp_coordinates_of(plane, 2), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_slope(scene, tp_exact_text("12.5"), TP_TOWARDS_LEFT, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_number(scene, "slope.dip_direction_deg", tp_exact_text("135"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_frame_base(scene, &message));
  SAY(tp_scene_set_base_mated(scene, false, &message));
  SAY(tp_scene_set_base_between(scene, tp_coordinates_text(feet, 2), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_base_mated(scene, false, &message));
  SAY(tp_scene_set_base_bound(scene, TP_BASE_BELOW, T("0.75"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  SAY(tp_scene_set_base_profile(scene, tp_coordinates_of(profile, 4), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_base_poses(scene, true, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_base_rest(scene, true, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_number(scene, "contact.within", T("0.125"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_number(scene, "contact.width", T("2.5"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_outline(scene, tp_coordinates_text(feet, 6), &message));
  SAY(tp_scene_set_base_mated(scene, true, &message));
  SAY(tp_scene_set_number(scene, "joint.shift", T("-0.125"), &message));
  SAY(tp_scene_set_number(scene, "joint.closure", T("0.1"), &message));
  SAY(tp_scene_set_friction_is_apparent(scene, false, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_joint_matching(scene, T("0.75"), false, &message));
  say_scene_built(s, scene);
}

/* Generated in doubles: in every thread the same digits. */
static void say_generated(sayings *s) {
  static const char text[] =
      "topple: 1\nlength_unit: mm\nblock: {outline: [[11.3, 9], [15.2, 9.4], [14.8, 15], [11, "
      "14]]}\n"
      "base:\n  profile:\n    self_affine: {length: 32, step: 0.25, hurst: 0.7, jrc: 12.5, seed: "
      "5}\n"
      "    noise: {deviation: 0.01, seed: 6}\n    worn: {rounded: 0.01}\n  place: rest\n"
      "friction_angle_deg: 31.5\n";
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  char path[100];
  SAY(tp_scene_read_text(&scene, text, "generated", &message));
  if (scene == NULL) return;
  SAY(tp_scene_profile_csv(next_saying(s), scene, &message));
  snprintf(path, sizeof path, "%s/profile.csv", s->folder);
  SAY(tp_scene_write_profile(path, scene, &message));
  say_file(s, path);
  say_scene_built(s, scene);
  tp_scene_free(scene);
}

/* The same by calls. */
static void say_made(sayings *s, tp_scene *scene) {
  tp_message message = {.text = ""};
  tp_base_teeth_options teeth = tp_base_teeth_options_default();
  tp_base_self_affine_options rough = tp_base_self_affine_options_default();
  teeth.count = 40;
  teeth.wavelength = T("1.1");
  teeth.amplitude = T("0.3");
  teeth.amplitude_scatter = teeth.skew_scatter = T("0.4");
  teeth.start_x = E(-12);
  teeth.start_y = E(-3);
  teeth.seed = 4;
  SAY(tp_scene_set_base_teeth(scene, &teeth, &message));
  SAY(tp_scene_set_base_rest(scene, true, &message));
  SAY(tp_scene_profile_csv(next_saying(s), scene, &message));
  rough.length = E(32);
  rough.step = T("0.25");
  rough.hurst = T("0.7");
  rough.by = TP_ROUGHNESS_JRC;
  rough.roughness = T("12.5");
  rough.start_x = E(-14);
  rough.start_y = E(-5);
  rough.seed = 5;
  SAY(tp_scene_set_base_self_affine(scene, &rough, &message));
  SAY(tp_scene_set_base_noise(scene, T("0.01"), 6, &message));
  SAY(tp_scene_set_base_scaled(scene, TP_ROUGHNESS_JRC, E(9), &message));
  SAY(tp_scene_set_base_worn(scene, TP_WEAR_ROUNDED, T("0.01"), &message));
  SAY(tp_scene_profile_csv(next_saying(s), scene, &message));
  SAY(tp_scene_set_base_rest(scene, true, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_base_jrc_profile(scene, 7, &message));
  SAY(tp_scene_profile_csv(next_saying(s), scene, &message));
}

static void say_outline_solved(sayings *s) {
  static const double outline[] = {0, 0, 4.1, 0, 4.3, 6.7, 0.3, 6.5};
  tp_message message = {.text = ""};
  tp_solution *solution = NULL;
  SAY(tp_solve_outline(&solution, outline, 4, "ft", 31.7, 12.3, &message));
  if (solution == NULL) return;
  same_times(solution);
  say_reports(s, solution);
  tp_solution_free(solution);
}

void say_built_shapes(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = begin(s);
  if (scene == NULL) return;
  say_outline_solved(s);
  say_generated(s);
  SAY(tp_scene_set_friction_angle_deg(scene, E(31.25), &message));
  say_forms(s, scene);
  say_bases(s, scene);
  say_made(s, scene);
  tp_scene_free(scene);
  scene = begin_square(s);
  if (scene == NULL) return;
  SAY(tp_scene_add_arc_through(scene, E(4), E(6), E(2), T("7.1"), &message));
  SAY(tp_scene_add_arc_bulge(scene, E(0), E(6), E(-0.1), &message));
  say_scene_built(s, scene);
  tp_scene_free(scene);
  scene = begin_square(s);
  if (scene == NULL) return;
  SAY(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(0.3), &message));
  SAY(tp_scene_add_rounded_vertex(scene, E(4), E(6), T("1.1"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_rounding_keeps_mass(scene, true, &message));
  say_scene_built(s, scene);
  tp_scene_free(scene);
}

void say_built_loads(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = begin_square(s);
  if (scene == NULL) return;
  SAY(tp_scene_set_number(scene, "loads.seismic.horizontal", T("0.1"), &message));
  SAY(tp_scene_set_number(scene, "loads.seismic.vertical", E(-0.05), &message));
  SAY(tp_scene_set_seismic_direction(scene, TP_SEISMIC_DOWN_DIP, &message));
  SAY(tp_scene_set_water(scene, E(2.9), T("9.81"), false, true, &message));
  say_scene_built(s, scene);
  SAY(tp_scene_add_pressure(scene, E(4), E(1), E(4), T("3.5"), E(5.5), E(10), &message));
  SAY(tp_scene_add_surcharge(scene, E(4), E(6), E(1.1), E(6), T("20.5"), &message));
  SAY(tp_scene_add_anchor(scene, E(0), T("4.9"), E(-30.5), E(50.1), false, &message));
  SAY(tp_scene_add_bolt(scene, E(0), T("4.9"), E(30.5), E(50.1), true, &message));
  SAY(tp_scene_set_bolt_towards(scene, 2, TP_TOWARDS_RIGHT, &message));
  SAY(tp_scene_set_bolt_length(scene, 2, T("9.5"), &message));
  SAY(tp_scene_set_bolt_capacity_kn(scene, 2, E(60.5), &message));
  SAY(tp_scene_set_bolt_spacing(scene, 2, T("1.5"), &message));
  SAY(tp_scene_set_bolt_rows(scene, 2, 2, E(0), E(-0.5), &message));
  SAY(tp_scene_add_support_pressure(scene, E(0), E(4), E(0), E(1), T("2.5"), E(1.5), true,
                                    &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_number(scene, "loads.cohesion_kpa", T("2.5"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_number(scene, "loads.bond_kpa", E(1.5), &message));
  say_scene_built(s, scene);
  tp_scene_free(scene);
}

/* Water by a level, a surface, a crack, and ice on it. */
void say_built_water(sayings *s) {
  static const double over[] = {-1, 4.5, 6, 3.25};
  tp_message message = {.text = ""};
  tp_scene *scene = begin_square(s);
  if (scene == NULL) return;
  SAY(tp_scene_set_tension_crack_height(scene, E(2.5), T("0.5"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_water_level(scene, T("3.3"), T("9.81"), TP_WATER_ON_BOTH, TP_WATER_UPLIFT_FULL,
                               &message));
  SAY(tp_scene_set_tension_crack_level(scene, E(3.5), &message));
  SAY(tp_scene_set_ice(scene, E(40.5), T("0.3"), &message));
  say_scene_built(s, scene);
  SAY(tp_scene_set_water_surface(scene, tp_coordinates_of(over, 2), T("9.81"), TP_WATER_BEHIND,
                                 TP_WATER_UPLIFT_TRIANGULAR, &message));
  say_scene_built(s, scene);
  tp_scene_free(scene);
}

/* Refused, by messages that tell numbers; the scene stays as it was. */
void say_built_refused(sayings *s) {
  static const double wrong[] = {0, 0, 4, 0, 4, NAN, 0, 6}, tiny[] = {0, 0, 4, 0, 4, 1e-320};
  static const char *const comma[] = {"0", "0", "4", "0", "4,5", "6"};
  tp_message message = {.text = ""};
  tp_scene *scene = begin_square(s), *none = NULL;
  if (scene == NULL) return;
  SAY(tp_scene_new(&none, "1,5 m", &message));
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(wrong, 4), &message));
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(tiny, 3), &message));
  SAY(tp_scene_set_outline(scene, tp_coordinates_text(comma, 3), &message));
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(square, SIZE_MAX), &message));
  SAY(tp_scene_set_friction_angle_deg(scene, T("30,5"), &message));
  SAY(tp_scene_set_friction_angle_deg(scene, E(90.5), &message));
  SAY(tp_scene_set_thickness(scene, E(1e-320), &message));
  SAY(tp_scene_set_thickness(scene, T("1e-400"), &message));
  SAY(tp_scene_set_tilt_angle_deg(scene, E(INFINITY), &message));
  SAY(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(-0.5), &message));
  SAY(tp_scene_set_teeth(scene, -3, E(1), E(1), E(1), TP_LEFT_END_PEAK, &message));
  SAY(tp_scene_set_slab(scene, E(1.5), T("-1/3"), &message));
  say_scene_built(s, scene);
  tp_scene_free(scene);
}
