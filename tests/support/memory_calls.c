/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_calls.h"

#include "memory_arrays.h"
#include "memory_charts.h"
#include "memory_drawings.h"
#include "memory_expect.h"
#include "memory_profiles.h"
#include "memory_samples.h"
#include "memory_studies.h"
#include "memory_tilt.h"

#include "report/sheet.h"
#include "topple.h"

#include <stdlib.h>
#include <string.h>

tp_status last_status;

/* A calculation sheet, with a file that it is of, translated. */
static void write_sheet(const tp_scene *scene, const tp_solution *solution, const char *path) {
  tp_sheet_options options = tp_sheet_options_default();
  options.language = "es";
  tp_sheet_files files = {0};
  tp_message message = {.text = ""};
  if (tp_sheet_files_read(&files, &path, 1, &message) != TP_OK) return;
  tp_document document = {0};
  char *html = NULL, *markdown = NULL;
  tp_sheet_head head = {0};
  if (tp_sheet_head_make(&head, NULL, &options, false, &message) != TP_OK) return;
  tp_sheet_build(&document, scene, solution, &files, &options, &head, (tp_picture){0});
  tp_status status = tp_document_html(&html, &document);
  expect_report(status, html);
  status = tp_document_markdown(&markdown, &document);
  expect_report(status, markdown);
  tp_document_clear(&document);
  tp_sheet_files_clear(&files);
}

static void solve_scene(const char *path, bool elements) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  tp_solve_options options = tp_solve_options_default();
  options.elements = elements;
  if (DONE(tp_scene_read(&scene, path, &message), scene) &&
      DONE(tp_solve(&solution, scene, &options, &message), solution)) {
    char *text = NULL, *json = NULL, *outlines = NULL, *account = NULL, *table = NULL;
    tp_status status = tp_report_text(&text, solution);
    expect_report(status, text);
    status = tp_report_json(&json, solution);
    expect_report(status, json);
    status = tp_report_json_outlines(&outlines, scene, solution, TP_PIVOTS_ALL, &message);
    expect_report(status, outlines);
    status = tp_report_elements(&account, solution);
    expect_report(status, account);
    status = tp_report_table(&table, (const tp_solution *const *)&solution, 1);
    expect_report(status, table);
    write_sheet(scene, solution, path);
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

static void solve_at_rest(void) {
  solve_scene(EXAMPLE("resting_block.yaml"), false);
}

static void solve_all_poses(void) {
  solve_scene(EXAMPLE("resting_poses.yaml"), false);
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
  tp_message message = {.text = ""};
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

/* A section of a mesh of two objects: block and ground. */
static void read_mesh(void) {
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  DONE(tp_scene_read(&scene, EXAMPLE("scanned_boulder.yaml"), &message), scene);
  tp_scene_free(scene);
}

/* With notes: cautions, and what a repair moved. */
static void solve_repaired(void) {
  static const char text[] =
      "topple: 1\nlength_unit: km\nblock:\n  unit_weight_kn_m3: 2600\n  repair: true\n"
      "  outline: [[0, 0], [3.333, 0.777], [3.4, 3], [1.7, 0.396], [1.2, 2], [0, 2.5]]\n";
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
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
  tp_message message = {.text = ""};
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
  tp_message message = {.text = ""};
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
  tp_message message = {.text = ""};
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
  tp_message message = {.text = ""};
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
  tp_message message = {.text = ""};
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

static void explain(void) {
  tp_message message = {.text = ""};
  char *text = NULL, *list = NULL;
  if (DONE(tp_report_explained(&text, "FoS", &message), text)) free(text);
  const tp_status status = tp_report_terms(&list);
  expect_report(status, list);
}

const memory_call memory_calls[] = {{"build a scene", build_scene, 200},
                                    {"vary blocks", vary_blocks, 100},
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
                                    {"read a mesh", read_mesh, 60},
                                    {"solve at rest", solve_at_rest, 100},
                                    {"solve all poses", solve_all_poses, 40},
                                    {"solve a limit precisely", solve_limit_precisely, 2000},
                                    {"measure accuracy", measure_accuracy, 60},
                                    {"solve rounded corners", solve_rounded, 100},
                                    {"solve an ellipse", solve_ellipse, 100},
                                    {"solve arcs", solve_arcs, 100},
                                    {"measure a profile", measure_profile, 60},
                                    {"a solid", solve_solid, 60},
                                    {"a solid that is cut", solve_cut_solid, 60},
                                    {"a solid that is thinned", solve_thinned_solid, 60},
                                    {"a solid on its ground", solve_solid_on_ground, 60},
                                    {"a wedge", solve_wedge, 60},
                                    {"measure a base", measure_base, 60},
                                    {"make profiles", make_profiles, 200},
                                    {"read drawings", read_drawings, 300},
                                    {"build profiles", build_profiles, 100},
                                    {"run a study", run_study, 200},
                                    {"merge a study", merge_study, 200},
                                    {"simulate a tilt test", simulate_tilt_test, 60},
                                    {"chart overturning", chart_overturning, 20},
                                    {"vary a tilt test", vary_tilt_test, 60},
                                    {"draw samples", draw_samples, 200},
                                    {"measure sensitivity", measure_sensitivity, 200},
                                    {"find reliability", find_reliability, 200},
                                    {"find", find, 40},
                                    {"explain", explain, 20},
                                    {"derive", derive, 200},
                                    {"derive and check", derive_checked, 60},
                                    {"derive for all counts", derive_family, 100},
                                    {"verify", verify, 100},
                                    {"chart fos", chart_fos, 100},
                                    {"chart mechanisms", chart_mechanisms, 40},
                                    {"chart ranges", chart_ranges, 20},
                                    {"chart map", chart_map, 40},
                                    {"chart map, contours", chart_map_contours, 4}};

const int memory_call_count = sizeof memory_calls / sizeof memory_calls[0];
