/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_arrays.h"

#include "memory_expect.h"

#include <stdio.h>
#include <stdlib.h>

/* Everything that a scene built in memory asks memory for. */
static tp_status build(tp_scene *scene, tp_message *message) {
  static const double outline[] = {0, 0, 4, 0, 4, 6, 0, 6}, hole[] = {1, 1, 2, 1, 2, 2, 1, 2};
  static const char *const part[] = {"2.5", "0.5", "7/2", "0.5", "7/2", "5"};
  const tp_exact one = tp_exact_of(1), four = tp_exact_of(4), five = tp_exact_of(5);
  tp_status status = tp_scene_set_title(scene, "Built", message);
  if (status == TP_OK) {
    status = tp_scene_set_outline(scene, tp_coordinates_of(outline, 4), message);
  }
  if (status == TP_OK) status = tp_scene_add_hole(scene, tp_coordinates_of(hole, 4), message);
  if (status == TP_OK) {
    status = tp_scene_add_part(scene, tp_coordinates_text(part, 3), tp_exact_text("20.5"), message);
  }
  if (status == TP_OK) status = tp_scene_set_unit_weight_kn_m3(scene, tp_exact_of(25), message);
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status =
        tp_scene_add_anchor(scene, tp_exact_of(0), five, tp_exact_of(-30), one, false, message);
  }
  if (status == TP_OK) status = tp_scene_set_friction_angle_deg(scene, five, message);
  if (status == TP_OK) status = tp_scene_add_friction_facets(scene, 1, 1, four, message);
  if (status == TP_OK)
    status = tp_scene_add_pressure(scene, four, one, four, five, one, one, message);
  return status;
}

static tp_status build_curves(tp_scene *scene, tp_message *message) {
  const tp_exact zero = tp_exact_of(0), one = tp_exact_of(1), six = tp_exact_of(6);
  tp_status status = tp_scene_add_arc_bulge(scene, zero, six, tp_exact_text("1/3"), message);
  if (status == TP_OK) status = tp_scene_add_arc_through(scene, zero, zero, one, one, message);
  if (status == TP_OK) {
    status = tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, one, message);
  }
  if (status == TP_OK) status = tp_scene_add_rounded_vertex(scene, six, six, one, message);
  return status;
}

void build_scene(void) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  if (DONE(tp_scene_new(&scene, "m", &message), scene)) {
    tp_status status = build(scene, &message);
    if (status == TP_OK && DONE(tp_solve(&solution, scene, &options, &message), solution)) {
      status = build_curves(scene, &message);
    }
    EXPECT(status == TP_OK || status == TP_OUT_OF_MEMORY, "status %d: %s", (int)status,
           message.text);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
}

/* Of many blocks too, and varied, which copies them. */
static tp_status build_blocks(tp_scene *scene, tp_message *message) {
  static const double low[] = {0, 0, 2, 0, 2, 1, 0, 1}, high[] = {2, 0, 3, 0, 3, 5, 2, 5},
                      hole[] = {0.5, 0.25, 1, 0.25, 1, 0.75};
  const tp_coordinates inside = tp_coordinates_of(hole, 3);
  const tp_exact one = tp_exact_of(1), two = tp_exact_of(2);
  tp_status status = tp_scene_add_block(scene, tp_coordinates_of(low, 4), "low", true, message);
  if (status == TP_OK) {
    status = tp_scene_add_block(scene, tp_coordinates_of(high, 4), NULL, false, message);
  }
  if (status == TP_OK) status = tp_scene_add_block_hole(scene, 1, inside, message);
  if (status == TP_OK) status = tp_scene_add_block_part(scene, 1, inside, one, message);
  if (status == TP_OK) status = tp_scene_add_joint(scene, 1, 2, message);
  if (status == TP_OK) status = tp_scene_set_joint_cohesion_kpa(scene, 1, one, message);
  if (status == TP_OK) status = tp_scene_add_force(scene, two, one, one, one, message);
  return status;
}

void vary_blocks(void) {
  tp_scene *scene = NULL, *varied = NULL;
  tp_message message = {.text = ""};
  if (DONE(tp_scene_new(&scene, "m", &message), scene)) {
    tp_status status = build_blocks(scene, &message);
    if (status == TP_OK) {
      status = tp_scene_with(&varied, scene, "joints.1.cohesion_kpa", tp_exact_of(2), &message);
    }
    EXPECT(status == TP_OK || status == TP_OUT_OF_MEMORY, "status %d: %s", (int)status,
           message.text);
  }
  tp_scene_free(varied);
  tp_scene_free(scene);
}

void solve_outline(void) {
  static const double outline[] = {0, 0, 30, 5, 60, 0, 90, 5, 90, 125, 0, 120};
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  DONE(tp_solve_outline(&solution, outline, 6, "mm", 30, 20, &message), solution);
  tp_solution_free(solution);
}

/* A slab that doubles decide, one with an overhang, which climbs, and one that is none. In the
 * thread that calls: the count of requests is of one. */
void solve_blocks(void) {
  static const double xy[] = {0, 0,  1, 0, 1, 2, 0, 2, 0, 0, 5, 0,
                              4, -1, 9, 9, 0, 0, 1, 1, 2, 2, 3, 3};
  const tp_outlines outlines = tp_outlines_of(xy, 3, 4);
  tp_blocks_options options = tp_blocks_options_default();
  options.threads = 1;
  double number[3];
  const tp_moment_columns area = {.area = number};
  const tp_critical_columns angle = {.angle_deg = number};
  const tp_verdict_columns limit = {.limit_angle_deg = number};
  tp_blocks_summary summary;
  tp_message message = {.text = ""};
  tp_status status = tp_outlines_moments(&area, &summary, &outlines, &options, &message);
  if (status == TP_OK) {
    status = tp_blocks_critical_angles(&angle, &summary, &outlines, &options, &message);
  }
  if (status == TP_OK) {
    status = tp_blocks_solve(&limit, &summary, &outlines, tp_numbers_of(30), tp_numbers_of(20),
                             &options, &message);
  }
  EXPECT(status == TP_OK || status == TP_OUT_OF_MEMORY, "status %d: %s", (int)status, message.text);
}

/* By settings, which are kept, in a scene that was varied, and varied once more. */
static void set_again(const tp_scene *scene, const char *const keys[2]) {
  tp_scene *set = NULL, *varied = NULL;
  tp_solution *solution = NULL;
  char setting[80], *report = NULL;
  tp_message message = {.text = ""};
  const char *const settings[] = {setting};
  const tp_solve_options options = tp_solve_options_default();
  snprintf(setting, sizeof setting, "%s=5+1/5", keys[1]);
  if (DONE(tp_scene_with_settings(&set, scene, settings, 1, &message), set) &&
      DONE(tp_scene_with(&varied, set, keys[0], tp_exact_of(5.5), &message), varied) &&
      DONE(tp_solve(&solution, varied, &options, &message), solution)) {
    const tp_solution *const all[] = {solution};
    const tp_status status = tp_report_csv(&report, all, 1);
    expect_report(status, report);
  }
  tp_solution_free(solution);
  tp_scene_free(varied);
  tp_scene_free(set);
}

static bool take_text(void *context, const char *text) {
  (void)context;
  return text[0] != '\0';
}

/* Over a point that is wrong, by a thread alone, as a thread that cannot be had is no failure. */
static void sweep_over(const tp_scene *scene, const char *key) {
  tp_sweep_summary summary = {.count = 0};
  tp_message message = {.text = ""};
  char axis[80];
  tp_sweep_options options = tp_sweep_options_default();
  snprintf(axis, sizeof axis, "%s=5.2,-1e9", key);
  options.x = axis;
  options.threads = 1;
  const tp_text_sink sink = {take_text, NULL};
  const tp_status status = tp_sweep_write(&summary, scene, &options, TP_SWEEP_CSV, sink, &message);
  EXPECT(status == TP_OK || status == TP_OUT_OF_MEMORY, "status %d: %s", (int)status, message.text);
}

/* One number of each: of a parameter and of a point, of an item and of a point. */
static void vary_scene(tp_scene *scene, const char *const keys[2], double number) {
  tp_scene *varied = NULL;
  tp_solution *solution = NULL;
  char *text = NULL;
  tp_message message = {.text = ""};
  const tp_exact values[2] = {tp_exact_of(number), tp_exact_text("5.1")};
  const tp_solve_options options = tp_solve_options_default();
  if (DONE(tp_scene_with_numbers(&varied, scene, keys, values, 2, &message), varied) &&
      DONE(tp_scene_number_text(&text, varied, keys[1], &message), text)) {
    set_again(varied, keys);
    sweep_over(varied, keys[1]);
    (void)DONE(tp_solve(&solution, varied, &options, &message), solution);
  }
  free(text);
  tp_solution_free(solution);
  tp_scene_free(varied);
}

void vary_scenes(void) {
  static const char *const of_file[2] = {"a", "tilt.angle_deg"};
  static const char *const built[2] = {"block.outline.3.2", "loads.anchors.3.force_kn"};
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  if (DONE(tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message), scene)) {
    vary_scene(scene, of_file, 31);
  }
  tp_scene_free(scene);
  scene = NULL;
  if (DONE(tp_scene_new(&scene, "m", &message), scene)) {
    const tp_status status = build(scene, &message);
    EXPECT(status == TP_OK || status == TP_OUT_OF_MEMORY, "%s", message.text);
    if (status == TP_OK) vary_scene(scene, built, 6.5);
  }
  tp_scene_free(scene);
}
