/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_calls.h"

#include "memory_charts.h"
#include "memory_expect.h"
#include "memory_profiles.h"

#include "topple.h"

#include <stdlib.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name

/* The call comes first, then its output is looked at. */
static tp_status last;
#define DONE(call, output) (last = (call), done(last, output, &message))

static void solve_scene(const char *path, bool elements) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {""};
  tp_solve_options options = tp_solve_options_default();
  options.elements = elements;
  if (DONE(tp_scene_read(&scene, path, &message), scene) &&
      DONE(tp_solve(&solution, scene, &options, &message), solution)) {
    char *text = NULL, *json = NULL, *account = NULL, *table = NULL;
    tp_status status = tp_report_text(&text, solution);
    expect_report(status, text);
    status = tp_report_json(&json, solution);
    expect_report(status, json);
    status = tp_report_elements(&account, solution);
    expect_report(status, account);
    status = tp_report_table(&table, (const tp_solution *const *)&solution, 1);
    expect_report(status, table);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
}

static void solve_teeth(void) {
  solve_scene(EXAMPLE("block_e_valley.yaml"), true);
}

static void solve_hole(void) {
  solve_scene(EXAMPLE("block_with_hole.yaml"), true);
}

static void solve_parts(void) {
  solve_scene(EXAMPLE("two_density_block.yaml"), true);
}

static void solve_outline_of_file(void) {
  solve_scene(EXAMPLE("boulder.yaml"), false);
}

static void solve_water(void) {
  solve_scene(EXAMPLE("block_under_water.yaml"), false);
}

static void solve_bond(void) {
  solve_scene(EXAMPLE("block_bonded.yaml"), false);
}

/* A limit whose facets only the simplex method at many bits tells apart. What is missing for want
 * of memory is not to be called undecided. */
static void solve_limit_precisely(void) {
  static const char text[] =
      "topple: 1\n"
      "length_unit: m\n"
      "block:\n"
      "  outline: [[0, 0], [45/2, -1/500000000000], [47/2, -1/500000000000], [0, 7/2]]\n"
      "  unit_weight_kn_m3: 1\n"
      "base:\n"
      "  mated: true\n"
      "loads:\n"
      "  cohesion_kpa: 2600\n"
      "friction_angle_deg: 74\n"
      "tilt: {towards: right}\n";
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {""};
  tp_solve_options options = tp_solve_options_default();
  options.digits = 30;
  if (DONE(tp_scene_read_text(&scene, text, "scene.yaml", &message), scene) &&
      DONE(tp_solve(&solution, scene, &options, &message), solution)) {
    char *json = NULL;
    const tp_status status = tp_report_json(&json, solution);
    EXPECT(status != TP_OK || strstr(json, "undecided") == NULL, "undecided: %s", json);
    expect_report(status, json);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
}

/* With notes: cautions, and what a repair moved. */
static void solve_repaired(void) {
  static const char text[] =
      "topple: 1\nlength_unit: km\nblock:\n  unit_weight_kn_m3: 2600\n  repair: true\n"
      "  outline: [[0, 0], [3.333, 0.777], [3.4, 3], [1.7, 0.396], [1.2, 2], [0, 2.5]]\n";
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {""};
  const tp_solve_options options = tp_solve_options_default();
  if (DONE(tp_scene_read_text(&scene, text, "scene.yaml", &message), scene) &&
      DONE(tp_solve(&solution, scene, &options, &message), solution)) {
    char *page = NULL;
    EXPECT(solution->notes.count == 4, "%zu notes", solution->notes.count);
    const tp_status status = tp_report_text(&page, solution);
    expect_report(status, page);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
}

/* Among its ways to the limit is the exact program of all columns. */
static void measure_accuracy(void) {
  tp_scene *scene = NULL;
  tp_accuracy *accuracy = NULL;
  tp_message message = {""};
  if (DONE(tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), scene) &&
      DONE(tp_accuracy_of_scene(&accuracy, scene, &message), accuracy)) {
    char *text = NULL;
    const tp_status status = tp_report_accuracy(&text, accuracy);
    expect_report(status, text);
  }
  tp_accuracy_free(accuracy);
  tp_scene_free(scene);
}

static void solve_rounded(void) {
  solve_scene(EXAMPLE("block_a_worn.yaml"), false);
}

static void solve_ellipse(void) {
  solve_scene(EXAMPLE("boulder_ellipse.yaml"), false);
}

static void solve_arcs(void) {
  solve_scene(EXAMPLE("vault.yaml"), false);
}

static void find(void) {
  tp_scene *scene = NULL;
  tp_found *found = NULL;
  tp_message message = {""};
  const tp_find_options options = {.size = sizeof options,
                                   .key = "block.rounded.corners.1.radius",
                                   .target = TP_FIND_CRITICAL_ANGLE,
                                   .value = 23.5};
  if (DONE(tp_scene_read(&scene, EXAMPLE("block_a_worn.yaml"), &message), scene) &&
      DONE(tp_find(&found, scene, &options, &message), found)) {
    EXPECT(found->count == 1, "%zu solutions",
           found->count); /* a scene that failed is no end of the range */
    char *text = NULL;
    const tp_status status = tp_report_found(&text, found, &options);
    expect_report(status, text);
  }
  tp_found_free(found);
  tp_scene_free(scene);
}

static void derive_scene(const char *path, const tp_derive_options *options) {
  tp_scene *scene = NULL;
  tp_derivation *derivation = NULL;
  tp_message message = {""};
  if (DONE(tp_scene_read(&scene, path, &message), scene) &&
      DONE(tp_derive(&derivation, scene, options, &message), derivation)) {
    char *text = NULL, *json = NULL;
    tp_status status = tp_report_derivation(&text, derivation);
    expect_report(status, text);
    status = tp_report_derivation_json(&json, derivation);
    expect_report(status, json);
  }
  tp_derivation_free(derivation);
  tp_scene_free(scene);
}

static void derive(void) {
  const tp_derive_options options = {sizeof options, TP_NOTATION_TEXT, true, true, true, false};
  derive_scene(EXAMPLE("block_e_valley.yaml"), &options);
}

/* Conditions that are looked at from both sides. */
static void derive_checked(void) {
  const tp_derive_options options = {sizeof options, TP_NOTATION_TEXT, false, false, true, true};
  derive_scene(EXAMPLE("block_a_peak.yaml"), &options);
}

static void derive_family(void) {
  tp_scene *scene = NULL;
  tp_family *family = NULL;
  tp_message message = {""};
  if (DONE(tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message), scene) &&
      DONE(tp_derive_family(&family, scene, TP_NOTATION_LATEX, &message), family)) {
    char *text = NULL;
    const tp_status status = tp_report_family(&text, family);
    expect_report(status, text);
  }
  tp_family_free(family);
  tp_scene_free(scene);
}

static void verify(void) {
  static const char claims[] =
      "topple_claims: 1\n"
      "angles: {phi: 30}\n"
      "geometries: {slab: {scene: paper/slab.yaml}}\n"
      "claims:\n"
      "- {id: a, where: a, geometry: slab, quantity: critical_angle, printed: tan^-1(dx/y)}\n"
      "- {id: b, where: b, geometry: slab, quantity: fos, printed: tan alpha*(dx/y)}\n"
      "- {id: c, where: c, quantity: sin(phi)^2 + cos(phi)^2, printed: '1.0'}\n";
  tp_verification *verification = NULL;
  tp_message message = {""};
  if (DONE(tp_verify_text(&verification, claims, EXAMPLE("claims.yaml"), &message), verification)) {
    char *text = NULL, *json = NULL, *page = NULL;
    tp_status status = tp_report_verification(&text, verification);
    expect_report(status, text);
    status = tp_report_verification_json(&json, verification);
    expect_report(status, json);
    status = tp_report_verification_markdown(&page, verification);
    expect_report(status, page);
  }
  tp_verification_free(verification);
}

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

static void build_scene(void) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {""};
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

static void solve_outline(void) {
  static const double outline[] = {0, 0, 30, 5, 60, 0, 90, 5, 90, 125, 0, 120};
  tp_solution *solution = NULL;
  tp_message message = {""};
  DONE(tp_solve_outline(&solution, "mm", outline, 6, 30, 20, &message), solution);
  tp_solution_free(solution);
}

/* A slab that doubles decide, one with an overhang, which climbs, and one that is none. In the
 * thread that calls: the count of requests is of one. */
static void solve_blocks(void) {
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
  tp_message message = {""};
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

/* One number of each: of a parameter and of a point, of an item and of a point. */
static void vary_scene(tp_scene *scene, const char *const keys[2], double number) {
  tp_scene *varied = NULL;
  tp_solution *solution = NULL;
  char *text = NULL;
  tp_message message = {""};
  const tp_exact values[2] = {tp_exact_of(number), tp_exact_text("5.1")};
  const tp_solve_options options = tp_solve_options_default();
  if (DONE(tp_scene_with_numbers(&varied, scene, keys, values, 2, &message), varied) &&
      DONE(tp_scene_number_text(&text, varied, keys[1], &message), text)) {
    (void)DONE(tp_solve(&solution, varied, &options, &message), solution);
  }
  free(text);
  tp_solution_free(solution);
  tp_scene_free(varied);
}

static void vary_scenes(void) {
  static const char *const of_file[2] = {"a", "tilt.angle_deg"};
  static const char *const built[2] = {"block.outline.3.2", "loads.anchors.3.force_kn"};
  tp_scene *scene = NULL;
  tp_message message = {""};
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

const memory_call memory_calls[] = {{"build a scene", build_scene, 200},
                                    {"solve an outline", solve_outline, 200},
                                    {"vary scenes", vary_scenes, 200},
                                    {"solve teeth", solve_teeth, 200},
                                    {"solve a hole", solve_hole, 200},
                                    {"solve parts", solve_parts, 100},
                                    {"solve an outline of a file", solve_outline_of_file, 100},
                                    {"solve water", solve_water, 100},
                                    {"solve blocks", solve_blocks, 200},
                                    {"solve repaired", solve_repaired, 100},
                                    {"solve bond", solve_bond, 100},
                                    {"solve a limit precisely", solve_limit_precisely, 2000},
                                    {"measure accuracy", measure_accuracy, 60},
                                    {"solve rounded corners", solve_rounded, 100},
                                    {"solve an ellipse", solve_ellipse, 100},
                                    {"solve arcs", solve_arcs, 100},
                                    {"measure a profile", measure_profile, 60},
                                    {"measure a base", measure_base, 60},
                                    {"find", find, 40},
                                    {"derive", derive, 200},
                                    {"derive and check", derive_checked, 60},
                                    {"derive for all counts", derive_family, 100},
                                    {"verify", verify, 100},
                                    {"chart fos", chart_fos, 100},
                                    {"chart mechanisms", chart_mechanisms, 40},
                                    {"chart ranges", chart_ranges, 20},
                                    {"chart map", chart_map, 40}};

const int memory_call_count = sizeof memory_calls / sizeof memory_calls[0];
