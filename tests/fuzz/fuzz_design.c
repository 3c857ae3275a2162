/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks as a design has them, drawn from bytes: on a slope, in the world or on a table; water by
 * its level, bolts and linings, a sole that is levelled, chords for arcs, partial factors and load
 * cases. Most numbers are such that a scene is valid; a few are at the ends of what is taken and
 * beyond. */

#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>

#define PICK(b, words) ((words)[fuzz_pick(b, sizeof(words) / sizeof(words)[0])])

static const char *const sizes[] = {"1", "2", "0.5", "3", "1.25", "7/3", "4", "0", "-1", "1e9"};
static const char *const shares[] = {"1", "1.25", "1.35", "1.5", "1/0.8", "10", "0.9", "0", "11"};
static const char *const angles[] = {"20", "35", "15", "0", "45", "89", "90", "-30"};
static const char *const sides[] = {"left", "right"};
static const char *const truths[] = {"true", "false"};

/* ---- block and base ----------------------------------------------------------------------------
 */

/* A chain below from left to right, and back above it; perhaps with an arc above. */
static void put_block(FILE *out, fuzz_bytes *b) {
  const unsigned count = 2 + fuzz_pick(b, 4), with = fuzz_pick(b, 8);
  if (with == 7) {
    fprintf(out, "block: {slab: {width: %s, height: %s}", PICK(b, sizes), PICK(b, sizes));
  } else {
    fputs("block: {outline: [", out);
    for (unsigned k = 0; k < count; k++) fprintf(out, "[%u, 0.%u], ", 2 * k, fuzz_pick(b, 3));
    fprintf(out, "[%u, 4], [0, %u]]", 2 * (count - 1), 3 + fuzz_pick(b, 2));
    if ((with & 1) != 0) {
      fprintf(out, ", arcs: [{from: [%u, 4], bulge: 0.%u}]", 2 * (count - 1), 1 + fuzz_pick(b, 6));
    }
    if ((with & 2) != 0) fprintf(out, ", arc_tolerance: 0.%u", fuzz_pick(b, 10));
  }
  fputs(", unit_weight_kn_m3: 26}\n", out);
  if ((with & 4) != 0) fprintf(out, "base: {mated: true, smooth: %s}\n", PICK(b, sizes));
}

static void put_place(FILE *out, fuzz_bytes *b) {
  switch (fuzz_pick(b, 4)) {
  case 0:
    fprintf(out, "slope: {dip_deg: %s, towards: %s}\n", PICK(b, angles), PICK(b, sides));
    break;
  case 1:
    fputs("frame: world\n", out);
    break;
  case 2:
    fprintf(out, "tilt: {towards: %s, angle_deg: %s}\n", PICK(b, sides), PICK(b, angles));
    break;
  default:
    fprintf(out, "slope: {dip_deg: 25, towards: %s}\n", PICK(b, sides));
  }
}

/* ---- loads -------------------------------------------------------------------------------------
 */

static void put_water(FILE *out, fuzz_bytes *b) {
  static const char *const faces[] = {"behind", "front", "both"};
  static const char *const uplifts[] = {"none", "triangular", "full", "true", "false"};
  fputs("water: {", out);
  switch (fuzz_pick(b, 5)) {
  case 0:
    fprintf(out, "level: %s", PICK(b, sizes));
    break;
  case 1:
    fprintf(out, "surface: [[-3, %s], [3, %s], [9, %s]]", PICK(b, sizes), PICK(b, sizes),
            PICK(b, sizes));
    break;
  case 2:
    fprintf(out, "tension_crack: {level: %s}", PICK(b, sizes));
    break;
  case 3:
    fprintf(out, "tension_crack: {height: %s, distance: %s}", PICK(b, sizes), PICK(b, sizes));
    break;
  default:
    fprintf(out, "height: %s", PICK(b, sizes));
  }
  const unsigned with = fuzz_pick(b, 8);
  if ((with & 1) != 0) fprintf(out, ", faces: %s", PICK(b, faces));
  if ((with & 2) != 0) fprintf(out, ", uplift: %s", PICK(b, uplifts));
  if ((with & 4) != 0) fprintf(out, ", ice_kpa: %s, ice_thickness: 0.3", PICK(b, sizes));
  fputs("}", out);
}

static void put_bolt(FILE *out, fuzz_bytes *b) {
  fprintf(out, "{at: [%u, %u], dip_deg: %s, towards: %s", 2 * fuzz_pick(b, 4), fuzz_pick(b, 5),
          PICK(b, angles), PICK(b, sides));
  const unsigned with = fuzz_pick(b, 32);
  if ((with & 1) == 0) fprintf(out, ", force_kn: %u", fuzz_pick(b, 200));
  if ((with & 2) != 0) fprintf(out, ", capacity_kn: %u", fuzz_pick(b, 250));
  if ((with & 4) != 0) fprintf(out, ", length: %u", fuzz_pick(b, 30));
  if ((with & 8) != 0) fprintf(out, ", spacing: %s", PICK(b, sizes));
  if ((with & 16) != 0) fprintf(out, ", rows: %u, row_step: [0, -0.5]", fuzz_pick(b, 4));
  fprintf(out, ", passive: %s}", PICK(b, truths));
}

/* As the map behind `loads:`. */
static void put_loads(FILE *out, fuzz_bytes *b) {
  const unsigned with = fuzz_pick(b, 32);
  fprintf(out, "{cohesion_kpa: %u", fuzz_pick(b, 20));
  if ((with & 1) != 0) {
    fputs(", ", out);
    put_water(out, b);
  }
  if ((with & 2) != 0) fprintf(out, ", seismic: {horizontal: 0.%u}", fuzz_pick(b, 10));
  if ((with & 4) != 0) {
    fputs(", anchors: [", out);
    put_bolt(out, b);
    fputs("]", out);
  }
  if ((with & 8) != 0) {
    fprintf(out, ", support_pressures: [{from: [0, %u], to: [0, 0], kpa: %u}]", fuzz_pick(b, 5),
            fuzz_pick(b, 40));
  }
  if ((with & 16) != 0) fputs(", surcharges: [{from: [2, 4], to: [0, 4], kpa: 5}]", out);
  fputs("}", out);
}

/* ---- what the block must reach -----------------------------------------------------------------
 */

static void put_factors(FILE *out, fuzz_bytes *b) {
  static const char *const sets[] = {"DA1-1", "DA1-2",      "DA2",  "DA3",
                                     "EQU",   "LRFD-slope", "EQ U", "LRFD-slope-limited"};
  static const char *const keys[] = {"permanent_unfavourable",
                                     "permanent_favourable",
                                     "water_unfavourable",
                                     "variable_unfavourable",
                                     "variable_favourable",
                                     "earthquake",
                                     "friction",
                                     "cohesion",
                                     "anchor",
                                     "resistance"};
  if (fuzz_pick(b, 3) < 2) {
    fputs(PICK(b, sets), out);
  } else {
    fprintf(out, "{%s: %s}", PICK(b, keys), PICK(b, shares));
  }
}

static void put_case(FILE *out, fuzz_bytes *b, unsigned number) {
  const unsigned with = fuzz_pick(b, 16);
  fprintf(out, "- name: %s\n",
          with == 15 ? "same" : (const char *[]){"dry", "wet", "same"}[number]);
  if ((with & 1) != 0) {
    fputs("  loads: ", out);
    put_loads(out, b);
    fputs("\n", out);
  }
  if ((with & 6) == 2) fprintf(out, "  required_fos: %s\n", PICK(b, shares));
  if ((with & 6) == 4) {
    fputs("  partial_factors: ", out);
    put_factors(out, b);
    fputs("\n", out);
  }
  if ((with & 8) != 0) fprintf(out, "  set: {friction_angle_deg: %s}\n", PICK(b, angles));
}

static char *draw(fuzz_bytes *b) {
  char *text = NULL;
  size_t length = 0;
  FILE *out = open_memstream(&text, &length);
  FUZZ_EXPECT(out != NULL);
  fputs("topple: 1\nlength_unit: m\n", out);
  put_block(out, b);
  put_place(out, b);
  fprintf(out, "friction_angle_deg: %s\n", PICK(b, angles));
  if (fuzz_pick(b, 8) == 7) fputs("friction_is: apparent\n", out);
  fputs("loads: ", out);
  put_loads(out, b);
  fputs("\n", out);
  if (fuzz_pick(b, 4) == 3) {
    fputs("partial_factors: ", out);
    put_factors(out, b);
    fputs("\n", out);
  }
  const unsigned cases = fuzz_pick(b, 4);
  if (cases > 0) fputs("cases:\n", out);
  for (unsigned k = 0; k < cases; k++) put_case(out, b, k);
  fclose(out);
  return text;
}

/* ---- solved ------------------------------------------------------------------------------------
 */

static void solve_cases(const tp_scene *scene, const tp_solve_options *options) {
  tp_load_cases *cases = NULL;
  tp_message message = {.text = ""};
  char *text = NULL;
  const tp_status status = tp_solve_load_cases(&cases, scene, NULL, 0, options, &message);
  fuzz_judge(status, cases, &message);
  if (status != TP_OK) return;
  FUZZ_EXPECT(cases->count == tp_scene_load_case_count(scene));
  for (size_t k = 0; k < cases->count; k++) fuzz_report(cases->cases[k].solution);
  FUZZ_EXPECT(tp_report_load_cases(&text, cases) == TP_OK);
  free(text);
  FUZZ_EXPECT(tp_report_load_cases_json(&text, cases, TP_PIVOTS_ALL) == TP_OK);
  fuzz_judge_json(text);
  free(text);
  tp_load_cases_free(cases);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  char *text = draw(&bytes);
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_scene_read_text(&scene, text, "drawn.yaml", &message);
  fuzz_judge(status, scene, &message);
  if (status == TP_OK && tp_scene_load_case_count(scene) > 0) {
    solve_cases(scene, &options);
  } else if (status == TP_OK) {
    status = tp_solve(&solution, scene, &options, &message);
    fuzz_judge(status, solution, &message);
    if (status == TP_OK) fuzz_report(solution);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
  free(text);
  return 0;
}
