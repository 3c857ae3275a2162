/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the rows of core/terms/keys.csv name: whether a scene has a number, and what follows from
 * it, as in the calls that build a scene. */

#include "scene_varying/slot_table.h"

#include "scene_building/build.h"
#include "scene_keys.h"

/* ---- what a scene has --------------------------------------------------------------------------
 */

static bool is_outline(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_VERTICES;
}

static bool is_slab(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_SLAB;
}

static bool is_ellipse(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_ELLIPSE;
}

static bool is_teeth(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_TEETH;
}

/* Over a width of the block; or tooth by tooth. */
static bool is_over(const tp_scene *scene) {
  return is_teeth(scene) && scene->block.teeth.block_width.given;
}

static bool is_counted(const tp_scene *scene) {
  return is_teeth(scene) && !scene->block.teeth.block_width.given;
}

static bool is_listed(const tp_scene *scene) {
  return scene->base.rule.made == TP_MADE_OF_POINTS;
}

static bool is_of_teeth(const tp_scene *scene) {
  return scene->base.rule.made == TP_MADE_OF_TEETH;
}

static bool is_self_affine(const tp_scene *scene) {
  return scene->base.rule.made == TP_MADE_SELF_AFFINE;
}

static bool is_barton(const tp_scene *scene) {
  return scene->friction.load_dependent;
}

static bool is_plain_angle(const tp_scene *scene) {
  return !scene->friction.load_dependent && !scene->friction.basic_angle_deg.given;
}

static bool is_mated(const tp_scene *scene) {
  return scene->base.mated;
}

static bool is_on_slope(const tp_scene *scene) {
  return scene->frame == TP_FRAME_SLOPE;
}

static bool is_wet(const tp_scene *scene) {
  return scene->loads.water.given;
}

static bool is_sited(const tp_scene *scene) {
  return tp_water_is_sited(&scene->loads.water);
}

static bool is_filled(const tp_scene *scene) {
  return is_wet(scene) && !is_sited(scene);
}

static bool is_levelled(const tp_scene *scene) {
  return scene->loads.water.level.given;
}

static bool is_under_surface(const tp_scene *scene) {
  return scene->loads.water.surface.count > 0;
}

static bool is_cracked_to_level(const tp_scene *scene) {
  return scene->loads.water.crack_level.given;
}

static bool is_cracked_to_height(const tp_scene *scene) {
  return scene->loads.water.crack_height.given;
}

static bool is_recorded_across(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_RECORD;
}

static bool is_recorded_upright(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_VERTICAL].form == TP_SHAKING_RECORD;
}

static bool is_half_sine_across(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_HALF_SINE;
}

static bool is_full_sine_across(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_FULL_SINE;
}

static bool is_half_sine_upright(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_VERTICAL].form == TP_SHAKING_HALF_SINE;
}

static bool is_full_sine_upright(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_VERTICAL].form == TP_SHAKING_FULL_SINE;
}

/* ---- what follows ------------------------------------------------------------------------------
 */

static tp_status settle_teeth(tp_scene *scene, void *holder, tp_message *message) {
  tp_teeth *teeth = &scene->block.teeth;
  (void)holder;
  if (!teeth->block_width.given) return TP_OK;
  fmpq_set(teeth->width, teeth->block_width.value);
  fmpq_set(teeth->height, teeth->mean_height.value);
  tp_teeth_over(teeth->width, teeth->height, teeth->depth, teeth->count);
  return tp_check_amplitude(teeth->height, scene->block.place, message);
}

static tp_status settle_ellipse(tp_scene *scene, void *holder, tp_message *message) {
  const tp_ellipse *ellipse = &scene->block.ellipse;
  (void)holder;
  return tp_check_flat(ellipse->flat.value, ellipse->width.value, scene->block.place, message);
}

static tp_status settle_friction(tp_scene *scene, void *holder, tp_message *message) {
  const tp_friction_description *law = &scene->friction;
  tp_quantity *angle = &scene->friction_angle_deg;
  (void)holder;
  if (law->basic_angle_deg.given) {
    fmpq_add(angle->value, law->basic_angle_deg.value, law->roughness_angle_deg.value);
    return tp_check_patton(angle->value, angle->place, message);
  }
  if (!law->test_angle_deg.given) return TP_OK;
  return tp_check_tilt_test(law->test_angle_deg.value, law->test_stress_kpa.value, angle->value,
                            law->jcs_mpa.value, angle->place, message);
}

static tp_status settle_facets(tp_scene *scene, void *holder, tp_message *message) {
  (void)scene;
  return tp_check_facet_range(holder, message);
}

static tp_status settle_plane(tp_scene *scene, void *holder, tp_message *message) {
  (void)holder;
  return tp_check_mean_plane(&scene->mean_plane, scene->frame_place, message);
}

static tp_status settle_outline(tp_scene *scene, void *holder, tp_message *message) {
  (void)holder;
  (void)message;
  tp_polyline_drop_closing_point(&scene->block.outline);
  return TP_OK;
}

static tp_status settle_hole(tp_scene *scene, void *holder, tp_message *message) {
  (void)scene;
  (void)message;
  tp_polyline_drop_closing_point(holder);
  return TP_OK;
}

static tp_status settle_part(tp_scene *scene, void *holder, tp_message *message) {
  tp_part *part = holder;
  (void)scene;
  (void)message;
  tp_polyline_drop_closing_point(&part->outline);
  return TP_OK;
}

/* The profile is another one. */
static tp_status settle_profile(tp_scene *scene, void *holder, tp_message *message) {
  (void)holder;
  return tp_build_profile(scene, message);
}

/* A surcharge is the same at both ends. */
static tp_status settle_surcharge(tp_scene *scene, void *holder, tp_message *message) {
  tp_line_load *load = holder;
  (void)scene;
  (void)message;
  fmpq_set(load->last_kpa.value, load->first_kpa.value);
  return TP_OK;
}

#define ROW(key, kind, list, offset, rule, has, settle)                                            \
  {key, TP_SLOT_##kind, list, offset, TP_RULE_##rule, has, settle},

static const tp_slot_row rows[] = {TP_SCENE_KEYS(ROW)};

const tp_slot_row *const tp_slot_rows = rows;
const size_t tp_slot_row_count = sizeof rows / sizeof rows[0];
