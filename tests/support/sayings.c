/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _GNU_SOURCE
#include "sayings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name

static void say_example(sayings *s, const char *path, bool elements, int digits, bool figure) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  note_status(s, tp_scene_read(&scene, path, &message), &message);
  if (scene != NULL) say_solved(s, scene, elements, digits, figure);
  tp_scene_free(scene);
}

/* An outline whose sums are taken in doubles at once. */
static void say_large(sayings *s) {
  char *text = malloc(4 << 20);
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  if (text == NULL) return;
  char *at =
      stpcpy(text, "topple: 1\nlength_unit: mm\ntilt: {towards: left}\nblock:\n  outline:\n");
  for (int k = 0; k <= 40000; k++) at += sprintf(at, "  - [%d, %d]\n", 7 * k, k * k % 11);
  strcpy(at, "  - [280000, 90000]\n  - [0, 90000]\n");
  note_status(s, tp_scene_read_text(&scene, text, "large", &message), &message);
  if (scene != NULL) say_solved(s, scene, false, 9, false);
  tp_scene_free(scene);
  free(text);
}

static void say_derivation(sayings *s, tp_notation notation) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  tp_derivation *derivation = NULL;
  tp_family *family = NULL;
  tp_derive_options options = tp_derive_options_default();
  options.notation = notation;
  options.elements = options.rounded = options.limit = true;
  note_status(s, tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message), &message);
  if (scene == NULL) return;
  note_status(s, tp_derive(&derivation, scene, &options, &message), &message);
  if (derivation != NULL && tp_report_derivation(next_saying(s), derivation) != TP_OK) s->count--;
  if (derivation != NULL && tp_report_derivation_json(next_saying(s), derivation) != TP_OK)
    s->count--;
  note_status(s, tp_derive_family(&family, scene, notation, &message), &message);
  if (family != NULL && tp_report_family(next_saying(s), family) != TP_OK) s->count--;
  if (family != NULL && tp_report_family_json(next_saying(s), family) != TP_OK) s->count--;
  tp_family_free(family);
  tp_derivation_free(derivation);
  tp_scene_free(scene);
}

static const char claims[] =
    "topple_claims: 1\ntitle: Numbers with decimals\n"
    "geometries: {slab: {scene: " EXAMPLE(
        "slab_left.yaml") "}}\n"
                          "claims:\n"
                          "- {id: angle, where: here, geometry: slab, quantity: critical_angle, "
                          "printed: 26.565}\n"
                          "- {id: formula, where: here, geometry: slab, quantity: critical_angle, "
                          "printed: atan(0.5)}\n";

static void say_verdicts(sayings *s) {
  tp_message message = {.text = ""};
  tp_verification *own = NULL, *paper = NULL;
  note_status(s, tp_verify_text(&own, claims, "claims", &message), &message);
  note_status(s, tp_verify(&paper, EXAMPLE("paper/claims.yaml"), &message), &message);
  const tp_verification *const both[2] = {own, paper};
  for (int k = 0; k < 2; k++) {
    if (both[k] == NULL) continue;
    if (tp_report_verification(next_saying(s), both[k]) != TP_OK) s->count--;
    if (tp_report_verification_json(next_saying(s), both[k]) != TP_OK) s->count--;
    if (tp_report_verification_markdown(next_saying(s), both[k]) != TP_OK) s->count--;
    note_number(s, tp_verification_objects(both[k]));
  }
  tp_verification_free(own);
  tp_verification_free(paper);
}

static void say_found(sayings *s, const char *path, const tp_find_options *options) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_found *found = NULL;
  const tp_solve_options solve = tp_solve_options_default();
  note_status(s, tp_scene_read(&scene, path, &message), &message);
  if (scene != NULL) note_status(s, tp_find(&found, scene, options, &message), &message);
  if (scene != NULL) note_status(s, tp_solve(&solution, scene, &solve, &message), &message);
  if (solution != NULL) same_times(solution);
  if (found != NULL && tp_report_found(next_saying(s), found, options) != TP_OK) s->count--;
  if (found != NULL && solution != NULL &&
      tp_report_found_json(next_saying(s), found, solution) != TP_OK) {
    s->count--;
  }
  tp_found_free(found);
  tp_solution_free(solution);
  tp_scene_free(scene);
}

/* By its place: an argument is read before a call beside it fills it in. */
static void say_chart(sayings *s, tp_status status, tp_chart *const *made,
                      const tp_message *message, bool draw) {
  tp_chart *chart = *made;
  note_status(s, status, message);
  if (chart == NULL) return;
  if (tp_report_chart_csv(next_saying(s), chart) != TP_OK) s->count--;
  if (tp_report_chart_json(next_saying(s), chart) != TP_OK) s->count--;
  if (draw) {
    tp_message why = {.text = ""};
    char path[100];
    snprintf(path, sizeof path, "%s/chart.svg", s->folder);
    note_status(s, tp_report_chart_file(path, chart, TP_CHART_SVG, &why), &why);
    say_file(s, path);
  }
  tp_chart_free(chart);
}

static void say_charts(sayings *s) {
  tp_message message = {.text = ""};
  tp_chart *chart[5] = {NULL};
  tp_scene *scene = NULL;
  note_status(s, tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), &message);
  const tp_chart_fos_options fos = tp_chart_fos_options_default();
  const tp_chart_mechanisms_options mechanisms = tp_chart_mechanisms_options_default();
  const tp_chart_map_options line = {.size = sizeof line,
                                     .scene = scene,
                                     .x = {"block.slab.width", {20.5, 149.25}},
                                     .y = {"tilt", {0, 90}}},
                             plane = {.size = sizeof plane,
                                      .scene = scene,
                                      .x = {"block.slab.width", {60.5, 70.25}},
                                      .y = {"block.slab.height", {50, 60}}};
  say_chart(s, tp_chart_fos(chart, &fos, &message), chart, &message, true);
  say_chart(s, tp_chart_mechanisms(chart + 1, &mechanisms, &message), chart + 1, &message, false);
  say_chart(s, tp_chart_ranges(chart + 2, &message), chart + 2, &message, false);
  say_chart(s, tp_chart_map(chart + 3, &line, &message), chart + 3, &message, true);
  say_chart(s, tp_chart_map(chart + 4, &plane, &message), chart + 4, &message, false);
  tp_scene_free(scene);
}

static void say_accuracy(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  tp_accuracy *of[2] = {NULL, NULL};
  tp_chart *chart[2] = {NULL, NULL};
  note_status(s, tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), &message);
  if (scene != NULL) note_status(s, tp_accuracy_of_scene(of, scene, &message), &message);
  note_status(s, tp_accuracy_sweep(of + 1, 10, 10, &message), &message);
  for (int k = 0; k < 2; k++) {
    if (of[k] == NULL) continue;
    for (size_t r = 0; r < of[k]->run_count; r++) of[k]->runs[r].seconds = 0.00123456789;
    if (tp_report_accuracy(next_saying(s), of[k]) != TP_OK) s->count--;
    if (tp_report_accuracy_json(next_saying(s), of[k]) != TP_OK) s->count--;
    say_chart(s, tp_chart_accuracy(chart + k, of[k], &message), chart + k, &message, false);
    tp_accuracy_free(of[k]);
  }
  tp_scene_free(scene);
}

static void say_block_e(sayings *s) {
  say_example(s, EXAMPLE("block_e_valley.yaml"), true, 9, true);
}

static void say_rounded(sayings *s) {
  say_example(s, EXAMPLE("block_a_worn.yaml"), false, 40, true);
}

static void say_water(sayings *s) {
  say_example(s, EXAMPLE("block_under_water.yaml"), false, 9, false);
}

static void say_outline_of_file(sayings *s) {
  say_example(s, EXAMPLE("boulder.yaml"), false, 9, false);
}

static void say_missing(sayings *s) {
  say_example(s, EXAMPLE("no such scene.yaml"), false, 9, false);
}

static void say_derivations(sayings *s) {
  for (int k = TP_NOTATION_TEXT; k <= TP_NOTATION_C; k++) say_derivation(s, (tp_notation)k);
}

static void say_critical_angle_found(sayings *s) {
  const tp_find_options options = {.size = sizeof options,
                                   .key = "block.slab.width",
                                   .target = TP_FIND_CRITICAL_ANGLE,
                                   .value = 20.25};
  say_found(s, EXAMPLE("slab_left.yaml"), &options);
}

static void say_limit_found(sayings *s) {
  const tp_find_options options = {.size = sizeof options,
                                   .key = "block.slab.width",
                                   .target = TP_FIND_LIMIT_ANGLE,
                                   .value = 30.5,
                                   .has_low = true,
                                   .has_high = true,
                                   .low = 10.5,
                                   .high = 100.25};
  say_found(s, EXAMPLE("slab_left.yaml"), &options);
}

const saying all_sayings[] = {{"block E", say_block_e},
                              {"rounded corners", say_rounded},
                              {"water", say_water},
                              {"an outline of a file", say_outline_of_file},
                              {"no such scene", say_missing},
                              {"a large outline", say_large},
                              {"derivations", say_derivations},
                              {"verdicts", say_verdicts},
                              {"find a critical angle", say_critical_angle_found},
                              {"find a limit", say_limit_found},
                              {"charts", say_charts},
                              {"accuracy", say_accuracy},
                              {"profiles", say_profiles},
                              {"solids", say_solids},
                              {"built", say_built},
                              {"built shapes", say_built_shapes},
                              {"built loads", say_built_loads},
                              {"built water", say_built_water},
                              {"built blocks", say_built_blocks},
                              {"built wrongly", say_built_refused},
                              {"blocks", say_blocks},
                              {"varied", say_varied},
                              {"studies", say_studies},
                              {"tilt tests", say_tilts},
                              {"names", say_names}};
const size_t all_sayings_count = sizeof all_sayings / sizeof all_sayings[0];

void say_everything(sayings *s) {
  for (size_t k = 0; k < all_sayings_count; k++) all_sayings[k].say(s);
}

void say_scene(sayings *s, const char *path, int digits) {
  say_example(s, path, true, digits, false);
}
