/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes whose bases are made by rule, with a number for every key of the rules. */

#include "keyed_scenes.h"

static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
#define HEAD                                                                                       \
  "topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [4, 0], [4, 6], [0, 6]], "                 \
  "unit_weight_kn_m3: 25}\n"

static void set_square(tp_scene *scene) {
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
}

static void build_teeth_base(tp_scene *scene, const double *n) {
  tp_base_teeth_options o = tp_base_teeth_options_default();
  set_square(scene);
  o.count = (long)n[0];
  o.wavelength = E(n[1]);
  o.amplitude = E(n[2]);
  o.skew = E(n[3]);
  o.wavelength_scatter = E(n[4]);
  o.amplitude_scatter = E(n[5]);
  o.skew_scatter = E(n[6]);
  o.start_x = E(n[7]);
  o.start_y = E(n[8]);
  o.seed = (long long)n[9];
  DO(tp_scene_set_base_teeth(scene, &o, &message));
  DO(tp_scene_set_base_worn(scene, TP_WEAR_ROUNDED, E(n[12]), &message));
  DO(tp_scene_set_base_noise(scene, E(n[10]), (long long)n[11], &message));
  DO(tp_scene_set_base_rest(scene, true, &message));
}

static tp_base_self_affine_options rough_options(void) {
  tp_base_self_affine_options o = tp_base_self_affine_options_default();
  o.length = E(32);
  o.step = E(0.25);
  o.hurst = E(0.75);
  o.start_x = E(-14);
  o.start_y = E(-5);
  o.seed = 7;
  return o;
}

static void build_self_affine(tp_scene *scene, const double *n) {
  tp_base_self_affine_options o = rough_options();
  set_square(scene);
  o.length = E(n[0]);
  o.step = E(n[1]);
  o.hurst = E(n[2]);
  o.roughness = E(n[3]);
  o.shortest = E(n[4]);
  o.longest = E(n[5]);
  o.start_x = E(n[6]);
  o.start_y = E(n[7]);
  o.seed = (long long)n[8];
  DO(tp_scene_set_base_self_affine(scene, &o, &message));
  DO(tp_scene_set_base_worn(scene, TP_WEAR_CUT, E(n[9]), &message));
  DO(tp_scene_set_base_rest(scene, true, &message));
}

static void build_rough(tp_scene *scene, const double *n) {
  tp_base_self_affine_options o = rough_options();
  set_square(scene);
  o.by = TP_ROUGHNESS_Z2;
  o.roughness = E(n[0]);
  DO(tp_scene_set_base_self_affine(scene, &o, &message));
  DO(tp_scene_set_base_scaled(scene, TP_ROUGHNESS_JRC, E(2), &message));
  DO(tp_scene_set_base_scaled(scene, TP_ROUGHNESS_RMS_HEIGHT, E(n[1]), &message));
  DO(tp_scene_set_base_worn(scene, TP_WEAR_ABRADED, E(n[2]), &message));
  DO(tp_scene_set_base_rest(scene, true, &message));
}

static void build_of_jrc(tp_scene *scene, const double *n) {
  tp_base_self_affine_options o = rough_options();
  set_square(scene);
  o.by = TP_ROUGHNESS_JRC;
  o.roughness = E(n[0]);
  DO(tp_scene_set_base_self_affine(scene, &o, &message));
  DO(tp_scene_set_base_noise(scene, E(0.125), 1, &message));
  DO(tp_scene_set_base_scaled(scene, TP_ROUGHNESS_JRC, E(n[1]), &message));
  DO(tp_scene_set_base_rest(scene, true, &message));
}

static void build_standard(tp_scene *scene, const double *n) {
  static const double small[] = {0.02, 1, 0.07, 1, 0.07, 1.05, 0.02, 1.05};
  DO(tp_scene_set_outline(scene, tp_coordinates_of(small, 4), &message));
  DO(tp_scene_set_base_jrc_profile(scene, (long)n[0], &message));
  DO(tp_scene_set_base_rest(scene, true, &message));
}

static void build_measured(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(n, 3), &message));
  DO(tp_scene_set_base_scaled(scene, TP_ROUGHNESS_Z2, E(n[6]), &message));
  DO(tp_scene_set_base_rest(scene, true, &message));
}

static void build_smooth(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_number(scene, "base.smooth", E(n[0]), &message));
}

enum { TEETH_BASE, SELF_AFFINE, ROUGH, OF_JRC, STANDARD, MEASURED, SMOOTH };

static const keyed_scene kinds[] = {
    [TEETH_BASE] =
        {build_teeth_base,
         HEAD "base:\n  profile:\n    teeth: {count: @a, wavelength: @b, amplitude: @c, skew: "
              "@d, left_end: valley, scatter: {wavelength: @e, amplitude: @f, skew: @g}, "
              "start: [@h, @i], seed: @j}\n    noise: {deviation: @k, seed: @l}\n"
              "    worn: {rounded: @m}\n  place: rest\n",
         {60, 1, 0.5, 0.25, 0.25, 0.5, 0.125, -14, -5, 5, 0.03125, 3, 0.03125}},
    [SELF_AFFINE] = {build_self_affine,
                     HEAD "base:\n  profile:\n    self_affine: {length: @a, step: @b, hurst: @c, "
                          "rms_height: @d, shortest: @e, longest: @f, start: [@g, @h], seed: @i}\n"
                          "    worn: {cut: @j}\n  place: rest\n",
                     {32, 0.25, 0.75, 0.5, 1, 16, -14, -5, 7, 0.125}},
    [ROUGH] = {build_rough,
               HEAD
               "base:\n  profile:\n    self_affine: {length: 32, step: 0.25, hurst: 0.75, z2: @a, "
               "start: [-14, -5], seed: 7}\n    scaled: {rms_height: @b}\n"
               "    worn: {abraded: @c}\n  place: rest\n",
               {0.25, 0.5, 0.125}},
    [OF_JRC] = {build_of_jrc, NULL, {8, 6}},
    [STANDARD] = {build_standard, NULL, {3}},
    [MEASURED] = {build_measured,
                  HEAD
                  "base: {profile: {measured: [[@a, @b], [@c, @d], [@e, @f]], scaled: {z2: @g}}, "
                  "place: rest}\n",
                  {-8, -4, 1, -6, 14, -3, 0.25}},
    [SMOOTH] = {build_smooth, HEAD "base: {smooth: @a}\n", {0.25}},
};

const keyed_row keyed_base_rows[KEYED_BASE_ROWS] = {
    {kinds + TEETH_BASE, "base.profile.teeth.count", 'a', 50},
    {kinds + TEETH_BASE, "base.profile.teeth.wavelength", 'b', 0.75},
    {kinds + TEETH_BASE, "base.profile.teeth.amplitude", 'c', 0.75},
    {kinds + TEETH_BASE, "base.profile.teeth.skew", 'd', -0.25},
    {kinds + TEETH_BASE, "base.profile.teeth.scatter.wavelength", 'e', 0.5},
    {kinds + TEETH_BASE, "base.profile.teeth.scatter.amplitude", 'f', 0.25},
    {kinds + TEETH_BASE, "base.profile.teeth.scatter.skew", 'g', 0.375},
    {kinds + TEETH_BASE, "base.profile.teeth.start.1", 'h', -13.75},
    {kinds + TEETH_BASE, "base.profile.teeth.start.2", 'i', -4},
    {kinds + TEETH_BASE, "base.profile.teeth.seed", 'j', 6},
    {kinds + TEETH_BASE, "base.profile.noise.deviation", 'k', 0.0625},
    {kinds + TEETH_BASE, "base.profile.noise.seed", 'l', 4},
    {kinds + TEETH_BASE, "base.profile.worn.rounded", 'm', 0.0625},
    {kinds + SELF_AFFINE, "base.profile.self_affine.length", 'a', 30},
    {kinds + SELF_AFFINE, "base.profile.self_affine.step", 'b', 0.0625},
    {kinds + SELF_AFFINE, "base.profile.self_affine.hurst", 'c', 0.5},
    {kinds + SELF_AFFINE, "base.profile.self_affine.rms_height", 'd', 0.75},
    {kinds + SELF_AFFINE, "base.profile.self_affine.shortest", 'e', 4},
    {kinds + SELF_AFFINE, "base.profile.self_affine.longest", 'f', 24},
    {kinds + SELF_AFFINE, "base.profile.self_affine.start.1", 'g', -12.5},
    {kinds + SELF_AFFINE, "base.profile.self_affine.start.2", 'h', -6},
    {kinds + SELF_AFFINE, "base.profile.self_affine.seed", 'i', 8},
    {kinds + SELF_AFFINE, "base.profile.worn.cut", 'j', 0.25},
    {kinds + ROUGH, "base.profile.self_affine.z2", 'a', 0.5},
    {kinds + ROUGH, "base.profile.scaled.rms_height", 'b', 0.25},
    {kinds + ROUGH, "base.profile.worn.abraded", 'c', 0.25},
    {kinds + OF_JRC, "base.profile.self_affine.jrc", 'a', 12},
    {kinds + OF_JRC, "base.profile.scaled.jrc", 'b', 9},
    {kinds + STANDARD, "base.profile.jrc_profile", 'a', 9},
    {kinds + MEASURED, "base.profile.measured.1.2", 'b', -3},
    {kinds + MEASURED, "base.profile.measured.2.1", 'c', 2},
    {kinds + MEASURED, "base.profile.scaled.z2", 'g', 0.125},
    {kinds + SMOOTH, "base.smooth", 'a', 0.5},
};
