/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that set the block of a scene in memory: outline, slab, teeth (Fig. 5; section 5.1 of the
 * paper) or ellipse, holes, parts, thickness and unit weight. */

#include "common/host.h"
#include "scene_building/build.h"

/* The block is of another form now; what the one before it said is dropped. */
static void set_form(tp_build *build, tp_outline_form form) {
  tp_block_description *block = &build->scene->block;
  tp_polyline_clear(&block->outline);
  block->form = form;
  block->place = build->place;
}

tp_status tp_scene_set_outline(tp_scene *scene, tp_coordinates outline, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_polyline line = {0};
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK)
    status = tp_coordinates_read(&line, outline, true, "outline", __func__, 0, message);
  if (status != TP_OK) return status;
  set_form(&build, TP_OUTLINE_VERTICES);
  scene->block.outline = line;
  return TP_OK;
}

/* Width, the lesser height and the depth of teeth are the first three numbers of the call. */
static void put_teeth(tp_build *build, long count, bool left_end_valley) {
  tp_teeth *teeth = &build->scene->block.teeth;
  teeth->count = count;
  teeth->left_end_valley = left_end_valley;
  fmpq_swap(teeth->width, build->values);
  fmpq_swap(teeth->height, build->values + 1);
  fmpq_swap(teeth->depth, build->values + 2);
  teeth->block_width.given = teeth->mean_height.given = false;
}

tp_status tp_scene_set_slab(tp_scene *scene, tp_exact width, tp_exact height, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"width", width, TP_RULE_ABOVE_ZERO},
                            {"height", height, TP_RULE_ABOVE_ZERO},
                            {"depth", {0, NULL}, TP_RULE_ANY}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 3);
  if (status == TP_OK) {
    set_form(&build, TP_OUTLINE_SLAB);
    put_teeth(&build, 1, false);
  }
  tp_build_end(&build);
  return status;
}

static tp_status check_teeth(tp_build *build, long count, tp_left_end left_end) {
  long own = 0;
  fmpq_t number;
  fmpq_init(number);
  fmpq_set_si(number, count, 1);
  const tp_status status =
      tp_check_tooth_count(&own, number, "count", build->place, build->message);
  fmpq_clear(number);
  if (status == TP_OK && left_end != TP_LEFT_END_VALLEY && left_end != TP_LEFT_END_PEAK) {
    return tp_refuse(build->message, TP_FAULT_ARGUMENT, build->place,
                     "left_end must be valley or peak");
  }
  return status;
}

tp_status tp_scene_set_teeth(tp_scene *scene, long count, tp_exact width, tp_exact height,
                             tp_exact depth, tp_left_end left_end, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"width", width, TP_RULE_ABOVE_ZERO},
                            {"height", height, TP_RULE_ABOVE_ZERO},
                            {"depth", depth, TP_RULE_NOT_NEGATIVE}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = check_teeth(&build, count, left_end);
  if (status == TP_OK) status = tp_build_read(&build, given, 3);
  if (status == TP_OK) {
    set_form(&build, TP_OUTLINE_TEETH);
    put_teeth(&build, count, left_end == TP_LEFT_END_VALLEY);
  }
  tp_build_end(&build);
  return status;
}

/* c = A; what was given is kept for those who ask for it, and vary it. */
tp_status tp_scene_set_teeth_over(tp_scene *scene, long count, tp_exact block_width,
                                  tp_exact mean_height, tp_exact amplitude, tp_left_end left_end,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"block_width", block_width, TP_RULE_ABOVE_ZERO},
                            {"mean_height", mean_height, TP_RULE_ABOVE_ZERO},
                            {"amplitude", amplitude, TP_RULE_NOT_NEGATIVE},
                            {"block_width", block_width, TP_RULE_ABOVE_ZERO},
                            {"mean_height", mean_height, TP_RULE_ABOVE_ZERO}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = check_teeth(&build, count, left_end);
  if (status == TP_OK) status = tp_build_read(&build, given, 5);
  if (status == TP_OK) {
    tp_teeth_over(build.values, build.values + 1, build.values + 2, count);
    status = tp_check_amplitude(build.values + 1, build.place, message);
  }
  if (status == TP_OK) {
    set_form(&build, TP_OUTLINE_TEETH);
    put_teeth(&build, count, left_end == TP_LEFT_END_VALLEY);
    tp_build_put(&build, &scene->block.teeth.block_width, 3);
    tp_build_put(&build, &scene->block.teeth.mean_height, 4);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_ellipse(tp_scene *scene, tp_exact width, tp_exact height, tp_exact flat,
                               tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"width", width, TP_RULE_ABOVE_ZERO},
                            {"height", height, TP_RULE_ABOVE_ZERO},
                            {"flat", flat, TP_RULE_ABOVE_ZERO}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 3);
  if (status == TP_OK) {
    status = tp_check_flat(build.values + 2, build.values, build.place, message);
  }
  if (status == TP_OK) {
    tp_ellipse *ellipse = &scene->block.ellipse;
    set_form(&build, TP_OUTLINE_ELLIPSE);
    tp_build_put(&build, &ellipse->width, 0);
    tp_build_put(&build, &ellipse->height, 1);
    tp_build_put(&build, &ellipse->flat, 2);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_build_hole(tp_build *build, tp_block_description *block, tp_coordinates outline) {
  void *holes = block->holes;
  tp_status status = tp_build_grow(build, &holes, block->hole_count, sizeof *block->holes);
  block->holes = holes;
  if (status == TP_OK) {
    status = tp_coordinates_read(block->holes + block->hole_count, outline, true, "outline",
                                 build->place.file, block->hole_count + 1, build->message);
  }
  if (status == TP_OK) block->hole_count++;
  return status;
}

tp_status tp_scene_add_hole(tp_scene *scene, tp_coordinates outline, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  return status == TP_OK ? tp_build_hole(&build, &scene->block, outline) : status;
}

tp_status tp_build_part(tp_build *build, tp_block_description *block, tp_coordinates outline,
                        tp_exact unit_weight_kn_m3) {
  const tp_given given = {"unit_weight_kn_m3", unit_weight_kn_m3, TP_RULE_UNIT_WEIGHT};
  void *parts = block->parts;
  tp_status status = tp_build_grow(build, &parts, block->part_count, sizeof *block->parts);
  block->parts = parts;
  if (status == TP_OK) status = tp_build_read(build, &given, 1);
  if (status == TP_OK) {
    tp_part *part = block->parts + block->part_count;
    status = tp_coordinates_read(&part->outline, outline, true, "outline", build->place.file,
                                 block->part_count + 1, build->message);
    if (status == TP_OK) {
      fmpq_init(part->unit_weight_kn_m3.value);
      tp_build_put(build, &part->unit_weight_kn_m3, 0);
      block->part_count++;
    }
  }
  tp_build_end(build);
  return status;
}

tp_status tp_scene_add_part(tp_scene *scene, tp_coordinates outline, tp_exact unit_weight_kn_m3,
                            tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  return status == TP_OK ? tp_build_part(&build, &scene->block, outline, unit_weight_kn_m3)
                         : status;
}

tp_status tp_scene_set_thickness(tp_scene *scene, tp_exact thickness, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "block.thickness", thickness, message);
}

tp_status tp_scene_set_unit_weight_kn_m3(tp_scene *scene, tp_exact unit_weight_kn_m3,
                                         tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "block.unit_weight_kn_m3", unit_weight_kn_m3, message);
}

tp_status tp_scene_set_repair(tp_scene *scene, bool repair, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  scene->block.repair = repair;
  scene->block.repair_place = build.place;
  return TP_OK;
}
