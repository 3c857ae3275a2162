/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes built in memory with loads, with friction by laws, and with numbers that are set again:
 * each has the solution of the file that says the same. */

#include "built_scene.h"

#include <stdio.h>
#include <stdlib.h>

static tp_scene *weighed_square(void) {
  static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_set_tilt_angle_deg(scene, E(10), &message));
  DO(tp_scene_set_tilt_towards(scene, true, false, &message));
  return scene;
}

#define WEIGHED SQUARE "  unit_weight_kn_m3: 25\ntilt: {towards: left, angle_deg: 10}\n"

START_TEST(loads) {
  tp_scene *scene = weighed_square();
  DO(tp_scene_set_friction_angle_deg(scene, E(35), &message));
  DO(tp_scene_set_number(scene, "loads.seismic.horizontal", T("0.1"), &message));
  DO(tp_scene_set_number(scene, "loads.seismic.vertical", T("-0.05"), &message));
  DO(tp_scene_set_water(scene, E(3), T("9.81"), false, true, &message));
  DO(tp_scene_add_pressure(scene, E(4), E(1), E(4), E(3), E(5), E(10), &message));
  DO(tp_scene_add_pressure(scene, E(4), E(4), E(4), E(5), E(2), E(2), &message));
  DO(tp_scene_add_surcharge(scene, E(4), E(6), E(1), E(6), E(20), &message));
  DO(tp_scene_add_anchor(scene, E(0), E(5), E(-30), E(50), false, &message));
  DO(tp_scene_add_anchor(scene, E(0), E(4), E(-20), E(10), true, &message));
  DO(tp_scene_add_bolt(scene, E(0), E(5), E(10), E(50), true, &message));
  DO(tp_scene_set_bolt_towards(scene, 3, TP_TOWARDS_RIGHT, &message));
  DO(tp_scene_set_bolt_length(scene, 3, E(7), &message));
  DO(tp_scene_set_bolt_capacity_kn(scene, 3, E(90), &message));
  DO(tp_scene_set_bolt_spacing(scene, 3, T("1.5"), &message));
  DO(tp_scene_set_bolt_rows(scene, 3, 2, E(0), E(-1), &message));
  DO(tp_scene_add_support_pressure(scene, E(0), E(4), E(0), E(1), E(3), E(2), false, &message));
  expect_same(scene, WEIGHED
              "friction_angle_deg: 35\nloads:\n  seismic: {horizontal: 0.1, vertical: -0.05}\n"
              "  water: {height: 3, uplift: true}\n  pressures: [{from: [4, 1], to: [4, 3], "
              "kpa: [5, 10]}, {from: [4, 4], to: [4, 5], kpa: 2}]\n"
              "  surcharges: [{from: [4, 6], to: [1, 6], kpa: 20}]\n"
              "  anchors: [{at: [0, 5], direction_deg: -30, force_kn: 50}, {at: [0, 4], "
              "direction_deg: -20, force_kn: 10, passive: true}, {at: [0, 5], dip_deg: 10, "
              "towards: right, force_kn: 50, length: 7, capacity_kn: 90, spacing: 1.5, rows: 2, "
              "row_step: [0, -1], passive: true}]\n"
              "  support_pressures: [{from: [0, 4], to: [0, 1], kpa: [3, 2], passive: false}]\n");
  scene = weighed_square();
  DO(tp_scene_set_number(scene, "loads.bond_kpa", E(30), &message));
  DO(tp_scene_set_water(scene, E(2), E(10), true, false, &message));
  expect_same(scene, WEIGHED "loads: {bond_kpa: 30, water: {height: 2, unit_weight_kn_m3: 10, "
                             "stays_level: true}}\n");
  scene = weighed_square();
  DO(tp_scene_set_number(scene, "loads.cohesion_kpa", E(12), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(28), &message));
  expect_same(scene, WEIGHED "loads: {cohesion_kpa: 12}\nfriction_angle_deg: 28\n");
}
END_TEST

START_TEST(friction) {
  tp_scene *scene = weighed_square();
  DO(tp_scene_set_friction_barton(scene, E(28), E(8), E(120), &message));
  expect_same(scene, WEIGHED "friction: {law: barton, residual_angle_deg: 28, jrc: 8, "
                             "jcs_mpa: 120}\n");
  scene = weighed_square();
  DO(tp_scene_set_friction_barton(scene, E(28), E(8), E(120), &message)); /* replaced */
  DO(tp_scene_set_friction_barton_test(scene, E(28), E(55), E(2.5), E(120), &message));
  expect_same(scene, WEIGHED "friction: {law: barton, residual_angle_deg: 28, jcs_mpa: 120, "
                             "tilt_test: {angle_deg: 55, normal_stress_kpa: 2.5}}\n");
  scene = weighed_square();
  DO(tp_scene_set_friction_barton_roughness(scene, E(28), E(12), E(120), &message));
  expect_same(scene, WEIGHED "friction: {law: barton, residual_angle_deg: 28, jcs_mpa: 120, "
                             "roughness_angle_deg: 12}\n");
  scene = weighed_square();
  DO(tp_scene_set_friction_barton(scene, E(28), E(8), E(120), &message)); /* replaced */
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  expect_same(scene, WEIGHED "friction_angle_deg: 30\n");
}
END_TEST

/* One scene solved at many numbers, as a sweep does. */
START_TEST(sweeps) {
  tp_scene *scene = weighed_square();
  for (int angle = 10; angle <= 60; angle += 10) {
    char text[400];
    DO(tp_scene_set_friction_angle_deg(scene, E(angle), &message));
    snprintf(text, sizeof text, WEIGHED "friction_angle_deg: %d\n", angle);
    tp_scene *read = NULL;
    DO(tp_scene_read_text(&read, text, "x", &message));
    expect_equal(solve(scene, 9), solve(read, 9));
    tp_scene_free(read);
  }
  tp_scene_free(scene);
}
END_TEST

SUITE(scene_new_loads) {
  Suite *suite = suite_create("scene_new_loads");
  TCase *tests = tcase_create("scenes");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, loads);
  tcase_add_test(tests, friction);
  tcase_add_test(tests, sweeps);
  suite_add_tcase(suite, tests);
  return suite;
}
