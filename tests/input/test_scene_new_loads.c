/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes built in memory with loads, with friction by laws, with numbers that are set again, and of
 * many blocks: each has the solution of the file that says the same. */

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

/* ---- many blocks -------------------------------------------------------------------------------
 */

static void add_box(tp_scene *scene, const char *name, bool ground, double x0, double y0, double x1,
                    double y1) {
  const double box[] = {x0, y0, x1, y0, x1, y1, x0, y1};
  DO(tp_scene_add_block(scene, tp_coordinates_of(box, 4), name, ground, &message));
}

/* A column beside a low block on ground. */
static tp_scene *columns(void) {
  tp_scene *scene = new_scene("m");
  add_box(scene, "ground", true, -9, -1, 9, 0);
  add_box(scene, NULL, false, 0, 0, 2, 1);
  add_box(scene, "column", false, 2, 0, 3, 5);
  DO(tp_scene_set_friction_angle_deg(scene, E(31), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_set_tilt_towards(scene, true, false, &message));
  return scene;
}

#define COLUMNS(of_low, of_column)                                                                 \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: 31\nblock: {unit_weight_kn_m3: 25}\n"            \
  "tilt: {towards: left}\nblocks:\n"                                                               \
  "- {name: ground, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n"                \
  "- {outline: [[0, 0], [2, 0], [2, 1], [0, 1]]" of_low "}\n"                                      \
  "- {name: column, outline: [[2, 0], [3, 0], [3, 5], [2, 5]]" of_column "}\n"

START_TEST(blocks) {
  static const double hole[] = {0.5, 0.25, 1, 0.25, 1, 0.75}, part[] = {2.25, 1, 2.75, 1, 2.5, 2};
  tp_scene *scene = columns();
  DO(tp_scene_set_block_unit_weight_kn_m3(scene, 2, E(20), &message));
  DO(tp_scene_add_block_hole(scene, 2, tp_coordinates_of(hole, 3), &message));
  DO(tp_scene_add_block_part(scene, 3, tp_coordinates_of(part, 3), E(19), &message));
  DO(tp_scene_add_joint(scene, 3, 2, &message));
  DO(tp_scene_set_joint_friction_angle_deg(scene, 1, E(17), &message));
  expect_same(
      scene,
      COLUMNS(
          ", unit_weight_kn_m3: 20, holes: [[[0.5, 0.25], [1, 0.25], [1, 0.75]]]",
          ", parts: [{outline: [[2.25, 1], [2.75, 1], [2.5, 2]], "
          "unit_weight_kn_m3: 19}]") "joints: [{between: [column, 2], friction_angle_deg: 17}]\n");
}
END_TEST

/* Every load, and what each of them can be told of blocks. */
START_TEST(loaded_blocks) {
  static const double surface[] = {-20, 0.5, 20, 2};
  tp_scene *scene = columns();
  DO(tp_scene_add_joint(scene, 2, 3, &message));
  DO(tp_scene_set_joint_cohesion_kpa(scene, 1, E(4), &message));
  DO(tp_scene_set_joint_tension_kpa(scene, 1, E(1), &message));
  DO(tp_scene_set_number(scene, "loads.seismic.horizontal", T("0.05"), &message));
  DO(tp_scene_set_water_surface(scene, tp_coordinates_of(surface, 2), T("9.81"), TP_WATER_BEHIND,
                                TP_WATER_UPLIFT_FULL, &message));
  DO(tp_scene_add_pressure(scene, E(3), E(3), E(3), E(5), E(4), E(0), &message));
  DO(tp_scene_set_load_block(scene, TP_PLACED_PRESSURE, 1, 3, &message));
  DO(tp_scene_add_surcharge(scene, E(2), E(1), E(0), E(1), E(6), &message));
  DO(tp_scene_set_load_block(scene, TP_PLACED_SURCHARGE, 1, 2, &message));
  DO(tp_scene_add_support_pressure(scene, E(0), E(1), E(0), E(0), E(2), E(2), true, &message));
  DO(tp_scene_set_load_block(scene, TP_PLACED_SUPPORT_PRESSURE, 1, 2, &message));
  DO(tp_scene_add_bolt_to(scene, E(2), E(4), E(8), T("-0.5"), E(30), false, &message));
  DO(tp_scene_set_bolt_spacing(scene, 1, E(2), &message));
  DO(tp_scene_add_bolt(scene, E(0), T("0.5"), E(20), E(5), true, &message));
  DO(tp_scene_set_bolt_towards(scene, 2, TP_TOWARDS_RIGHT, &message));
  DO(tp_scene_set_bolt_into(scene, 2, 1, &message));
  DO(tp_scene_set_load_block(scene, TP_PLACED_BOLT, 2, 2, &message));
  DO(tp_scene_add_force(scene, E(0), T("0.75"), E(0), E(3), &message));
  DO(tp_scene_set_load_block(scene, TP_PLACED_FORCE, 1, 2, &message));
  DO(tp_scene_set_support(scene, 2, E(0), T("0.5"), &message));
  DO(tp_scene_set_number(scene, "support.direction_deg", E(10), &message));
  DO(tp_scene_set_number(scene, "support.fos", T("1.3"), &message));
  expect_same(
      scene,
      COLUMNS(
          "",
          "") "joints: [{between: [2, column], cohesion_kpa: 4, tension_kpa: 1}]\n"
              "loads:\n  seismic: {horizontal: 0.05}\n"
              "  water: {surface: [[-20, 0.5], [20, 2]], faces: behind, uplift: full}\n"
              "  pressures: [{block: column, from: [3, 3], to: [3, 5], kpa: [4, 0]}]\n"
              "  surcharges: [{block: 2, from: [2, 1], to: [0, 1], kpa: 6}]\n"
              "  support_pressures: [{block: 2, from: [0, 1], to: [0, 0], kpa: 2}]\n"
              "  anchors: [{at: [2, 4], to: [8, -0.5], force_kn: 30, spacing: 2}, {block: 2, at: "
              "[0, 0.5], dip_deg: 20, towards: right, force_kn: 5, passive: true, into: ground}]\n"
              "  forces: [{block: 2, at: [0, 0.75], direction_deg: 0, force_kn: 3}]\n"
              "support: {block: 2, at: [0, 0.5], direction_deg: 10, fos: 1.3}\n");
}
END_TEST

/* The blocks of a varied scene are its own: those of the first stay, and go, as they were. */
START_TEST(varied_blocks) {
  tp_scene *scene = columns(), *varied = NULL;
  static const double hole[] = {0.5, 0.25, 1, 0.25, 1, 0.75};
  DO(tp_scene_add_joint(scene, 2, 3, &message));
  DO(tp_scene_set_joint_friction_angle_deg(scene, 1, E(17), &message));
  DO(tp_scene_with(&varied, scene, "joints.1.friction_angle_deg", E(20), &message));
  DO(tp_scene_add_block_hole(scene, 2, tp_coordinates_of(hole, 3), &message));
  tp_scene_free(scene);
  expect_same(varied, COLUMNS("", "") "joints: [{between: [2, column], friction_angle_deg: 20}]\n");
}
END_TEST

SUITE(scene_new_loads) {
  Suite *suite = suite_create("scene_new_loads");
  TCase *tests = tcase_create("scenes");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, loads);
  tcase_add_test(tests, friction);
  tcase_add_test(tests, sweeps);
  tcase_add_test(tests, blocks);
  tcase_add_test(tests, loaded_blocks);
  tcase_add_test(tests, varied_blocks);
  suite_add_tcase(suite, tests);
  return suite;
}
