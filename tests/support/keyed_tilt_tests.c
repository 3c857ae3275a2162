/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes that call for a simulated tilt test, with a number for every key of theirs. */

#include "keyed_scenes.h"

static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
static const double record[] = {0, 0, 0.25, 0.125, 0.5, -0.25, 0.75, 0};
#define HEAD                                                                                       \
  "topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [4, 0], [4, 6], [0, 6]], "                 \
  "unit_weight_kn_m3: 25}\nfriction_angle_deg: 30\n"

static void set_square(tp_scene *scene) {
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
}

static void build_springs(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_tilt_test(scene, TP_TILT_SPRINGS, TP_TILT_RAMP, false, &message));
  DO(tp_scene_set_number(scene, "tilt_test.speed_deg_min", E(n[0]), &message));
  DO(tp_scene_set_number(scene, "tilt_test.until_deg", E(n[1]), &message));
  DO(tp_scene_set_number(scene, "tilt_test.tolerance_deg", E(n[2]), &message));
  DO(tp_scene_set_number(scene, "tilt_test.duration_s", E(n[3]), &message));
  DO(tp_scene_set_tilt_test_stiffness_gpa_m(scene, E(n[4]), E(n[5]), &message));
  DO(tp_scene_set_number(scene, "tilt_test.damping", E(n[6]), &message));
  DO(tp_scene_set_number(scene, "tilt_test.rounding", E(n[7]), &message));
  DO(tp_scene_set_number(scene, "tilt_test.time_step_s", E(n[8]), &message));
}

/* Let go, level, on a base that shakes along both axes. */
static void let_go(tp_scene *scene, double restitution) {
  set_square(scene);
  DO(tp_scene_set_tilt_angle_deg(scene, E(0), &message));
  DO(tp_scene_set_tilt_test(scene, TP_TILT_RIGID, TP_TILT_RELEASE, false, &message));
  DO(tp_scene_set_number(scene, "tilt_test.restitution", E(restitution), &message));
}

static void set_pulses(tp_scene *scene, tp_pulse_shape shape, const double *n) {
  DO(tp_scene_set_shaking_pulse(scene, TP_SHAKES_HORIZONTALLY, shape, E(n[0]), E(n[1]), &message));
  DO(tp_scene_set_shaking_pulse(scene, TP_SHAKES_VERTICALLY, shape, E(n[2]), E(n[3]), &message));
}

static void build_half_sines(tp_scene *scene, const double *n) {
  let_go(scene, n[0]);
  set_pulses(scene, TP_PULSE_HALF_SINE, n + 1);
}

static void build_full_sines(tp_scene *scene, const double *n) {
  let_go(scene, 0);
  set_pulses(scene, TP_PULSE_FULL_SINE, n);
}

static void build_records(tp_scene *scene, const double *n) {
  let_go(scene, 0);
  const tp_coordinates own = tp_coordinates_of(record, 4);
  DO(tp_scene_set_shaking_record(scene, TP_SHAKES_HORIZONTALLY, own, E(n[0]), &message));
  DO(tp_scene_set_shaking_record(scene, TP_SHAKES_VERTICALLY, own, E(n[1]), &message));
}

static void build_locked(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_tilt_test(scene, TP_TILT_PATH, TP_TILT_RAMP, false, &message));
  DO(tp_scene_add_tilt_test_traction(scene, 1, E(n[0]), E(n[1]), E(n[2]), &message));
}

enum { SPRINGS, HALF_SINES, FULL_SINES, RECORDS, LOCKED, KINDS };

static const keyed_scene kinds[KINDS] = {
    {build_springs,
     HEAD "tilt_test: {engine: dynamics, method: springs, speed_deg_min: @a, until_deg: @b, "
          "tolerance_deg: @c, duration_s: @d, normal_stiffness_gpa_m: @e, "
          "shear_stiffness_gpa_m: @f, damping: @g, rounding: @h, time_step_s: @i}\n",
     {16, 80, 0.125, 2, 1000, 10, 0.75, 0.0009765625, 0.00006103515625}},
    {build_half_sines,
     HEAD "tilt: {angle_deg: 0}\n"
          "tilt_test: {engine: dynamics, method: events, protocol: release, restitution: @a}\n"
          "shaking: {horizontal: {half_sine: {peak_g: @b, frequency_hz: @c}}, vertical: "
          "{half_sine: {peak_g: @d, frequency_hz: @e}}}\n",
     {0.25, 0.5, 2, 0.125, 4}},
    {build_full_sines,
     HEAD "tilt: {angle_deg: 0}\n"
          "tilt_test: {engine: dynamics, method: events, protocol: release, restitution: 0}\n"
          "shaking: {horizontal: {full_sine: {peak_g: @a, frequency_hz: @b}}, vertical: "
          "{full_sine: {peak_g: @c, frequency_hz: @d}}}\n",
     {0.5, 2, 0.125, 4}},
    {build_records, NULL, {1, 0.5}},
    {build_locked,
     HEAD "tilt_test: {engine: path, tractions: [{facet: 1, normal_kpa: [@a, @b], shear_kpa: "
          "@c}]}\n",
     {20, 10, 5}},
};

const keyed_row keyed_test_rows[KEYED_TEST_ROWS] = {
    {kinds + SPRINGS, "tilt_test.speed_deg_min", 'a', 20},
    {kinds + SPRINGS, "tilt_test.until_deg", 'b', 60},
    {kinds + SPRINGS, "tilt_test.tolerance_deg", 'c', 0.25},
    {kinds + SPRINGS, "tilt_test.duration_s", 'd', 3},
    {kinds + SPRINGS, "tilt_test.normal_stiffness_gpa_m", 'e', 500},
    {kinds + SPRINGS, "tilt_test.shear_stiffness_gpa_m", 'f', 20},
    {kinds + SPRINGS, "tilt_test.damping", 'g', 0.5},
    {kinds + SPRINGS, "tilt_test.rounding", 'h', 0.001953125},
    {kinds + SPRINGS, "tilt_test.time_step_s", 'i', 0.00003051757812},
    {kinds + HALF_SINES, "tilt_test.restitution", 'a', 0.5},
    {kinds + HALF_SINES, "shaking.horizontal.half_sine.peak_g", 'b', 0.75},
    {kinds + HALF_SINES, "shaking.horizontal.half_sine.frequency_hz", 'c', 3},
    {kinds + HALF_SINES, "shaking.vertical.half_sine.peak_g", 'd', 0.25},
    {kinds + HALF_SINES, "shaking.vertical.half_sine.frequency_hz", 'e', 5},
    {kinds + FULL_SINES, "shaking.horizontal.full_sine.peak_g", 'a', 0.75},
    {kinds + FULL_SINES, "shaking.horizontal.full_sine.frequency_hz", 'b', 3},
    {kinds + FULL_SINES, "shaking.vertical.full_sine.peak_g", 'c', 0.25},
    {kinds + FULL_SINES, "shaking.vertical.full_sine.frequency_hz", 'd', 5},
    {kinds + RECORDS, "shaking.horizontal.record.scale", 'a', 2},
    {kinds + RECORDS, "shaking.vertical.record.scale", 'b', 0.25},
    {kinds + LOCKED, "tilt_test.tractions.1.normal_kpa.1", 'a', 25},
    {kinds + LOCKED, "tilt_test.tractions.1.normal_kpa.2", 'b', -5},
    {kinds + LOCKED, "tilt_test.tractions.1.shear_kpa", 'c', -2.5},
};
