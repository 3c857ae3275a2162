/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_profiles.h"

#include "memory_charts.h"
#include "memory_expect.h"

void measure_profile(void) {
  tp_profile *profile = NULL;
  tp_message message = {.text = ""};
  tp_profile_options options = tp_profile_options_default();
  options.step = 0.7;
  options.resampling = TP_RESAMPLE_SPLINE;
  tp_status status =
      tp_profile_of_file(&profile, EXAMPLE("joint_profile.csv"), "mm", &options, &message);
  if (done(status, profile, &message)) {
    char *text = NULL, *json = NULL, *csv = NULL;
    status = tp_report_profile(&text, profile);
    expect_report(status, text);
    status = tp_report_profile_json(&json, profile, true);
    expect_report(status, json);
    status = tp_report_profile_csv(&csv, profile);
    expect_report(status, csv);
    chart_profile(profile);
  }
  tp_profile_free(profile);
}

void measure_base(void) {
  tp_scene *scene = NULL;
  tp_profile *profile = NULL;
  tp_message message = {.text = ""};
  tp_profile_options options = tp_profile_options_default();
  options.jcs_mpa = 120;
  tp_status status = tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message);
  if (done(status, scene, &message)) {
    status = tp_profile_of_scene(&profile, scene, &options, &message);
    (void)done(status, profile, &message);
  }
  tp_profile_free(profile);
  tp_scene_free(scene);
}

#define MADE(profile)                                                                              \
  "topple: 1\nlength_unit: mm\nblock: {slab: {width: 3, height: 5}}\nbase: {profile: {" profile    \
  "}}\n"

void make_profiles(void) {
  static const char *const texts[] = {
      MADE("self_affine: {length: 64, step: 1, hurst: 0.8, jrc: 8, seed: 1}, worn: {cut: 0.5}"),
      MADE("teeth: {count: 20, wavelength: 6, amplitude: 1, left_end: peak, seed: 2, "
           "scatter: {amplitude: 0.5, skew: 0.2}}, worn: {rounded: 0.1}"),
      MADE("measured: [[0, 0], [1, 3], [2, 0], [3, 2]], noise: {deviation: 0.1, seed: 3}, "
           "worn: {abraded: 0.2}")};
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
    tp_scene *scene = NULL;
    tp_message message = {.text = ""};
    char *csv = NULL;
    tp_status status = tp_scene_read_text(&scene, texts[k], "made", &message);
    if (done(status, scene, &message)) {
      status = tp_scene_profile_csv(&csv, scene, &message);
      (void)done(status, csv, &message);
      status = tp_scene_write_profile("/dev/null", scene, &message);
      (void)done(status, status == TP_OK ? scene : NULL, &message);
    }
    free(csv);
    tp_scene_free(scene);
  }
}

/* By calls, and once more with another seed; what fails leaves the base as it was. */
void build_profiles(void) {
  static const double points[] = {0, 0, 1, 3, 2, 0, 3, 2};
  tp_scene *scene = NULL, *varied = NULL;
  tp_message message = {.text = ""};
  tp_base_teeth_options teeth = tp_base_teeth_options_default();
  teeth.count = 20;
  teeth.wavelength = tp_exact_of(6);
  teeth.amplitude = teeth.amplitude_scatter = tp_exact_of(1);
  tp_status status = tp_scene_new(&scene, "mm", &message);
  if (done(status, scene, &message)) {
    status = tp_scene_set_base_teeth(scene, &teeth, &message);
    (void)done(status, status == TP_OK ? scene : NULL, &message);
    status = tp_scene_set_base_profile(scene, tp_coordinates_of(points, 4), &message);
    (void)done(status, status == TP_OK ? scene : NULL, &message);
    status = tp_scene_set_base_jrc_profile(scene, 2, &message);
    (void)done(status, status == TP_OK ? scene : NULL, &message);
    status = tp_scene_set_base_noise(scene, tp_exact_of(0.125), 1, &message);
    if (done(status, status == TP_OK ? scene : NULL, &message)) {
      status = tp_scene_with(&varied, scene, "base.profile.noise.seed", tp_exact_of(2), &message);
      (void)done(status, varied, &message);
    }
    status = tp_scene_set_base_scaled(scene, TP_ROUGHNESS_JRC, tp_exact_of(5), &message);
    (void)done(status, status == TP_OK ? scene : NULL, &message);
    status = tp_scene_set_base_worn(scene, TP_WEAR_ROUNDED, tp_exact_of(0.125), &message);
    (void)done(status, status == TP_OK ? scene : NULL, &message);
  }
  tp_scene_free(varied);
  tp_scene_free(scene);
}

void solve_solid(void) {
  tp_solid *solid = NULL;
  tp_message message = {.text = ""};
  tp_solid_options options = tp_solid_options_default();
  options.friction_angle_deg = 30;
  tp_status status =
      tp_solid_of_file(&solid, EXAMPLE("solids/balanced_rock.obj"), &options, &message);
  if (done(status, solid, &message)) {
    char *text = NULL, *json = NULL, *csv = NULL;
    status = tp_report_solid(&text, solid);
    expect_report(status, text);
    status = tp_report_solid_json(&json, solid);
    expect_report(status, json);
    status = tp_report_solid_csv(&csv, solid);
    expect_report(status, csv);
  }
  tp_solid_free(solid);
}

static void solve_solid_scene(tp_status status, tp_scene *scene, tp_message *message) {
  tp_solid *solid = NULL;
  if (done(status, scene, message)) {
    status = tp_solve_solid(&solid, scene, message);
    if (done(status, solid, message)) {
      char *text = NULL, *json = NULL;
      status = tp_report_solid(&text, solid);
      expect_report(status, text);
      status = tp_report_solid_json(&json, solid);
      expect_report(status, json);
    }
  }
  tp_solid_free(solid);
  tp_scene_free(scene);
}

static void solve_example(const char *path) {
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read(&scene, path, &message);
  solve_solid_scene(status, scene, &message);
}

void solve_cut_solid(void) {
  solve_example(EXAMPLE("solids/rock_in_the_ground.yaml"));
}

void solve_solid_on_ground(void) {
  solve_example(EXAMPLE("solids/rock_on_ground.yaml"));
}

void solve_wedge(void) {
  solve_example(EXAMPLE("solids/bolted_wedge.yaml"));
  solve_example(EXAMPLE("solids/shaken_wedge.yaml"));
}

void solve_thinned_solid(void) {
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status =
      tp_scene_read_text(&scene,
                         "topple: 1\nlength_unit: m\nsolid: {file: '" EXAMPLE(
                             "solids/balanced_rock.obj") "', unit: m, bands: [0.01], thin: 0.02}\n",
                         "thinned", &message);
  solve_solid_scene(status, scene, &message);
}
