/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls on solids say: of a block that stands, of a file that is no solid, of a scene. */

#include "sayings.h"

#include <stdio.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name

static bool agree_once(void *context) {
  ++*(int *)context;
  return true;
}

static void say_solid_figure(sayings *s, const tp_solid *solid) {
  tp_message message = {.text = ""};
  char path[100];
  int asked = 0;
  const tp_figure_consent ask = {agree_once, &asked};
  snprintf(path, sizeof path, "%s/solid.svg", s->folder);
  note_status(s, tp_report_figure_solid(path, solid, &message), &message);
  say_file(s, path);
  note_status(s, tp_report_figure_solid_if(path, solid, ask, &message), &message);
  note_number(s, asked);
}

static void say_solid_sheet(sayings *s, const tp_scene *scene, const tp_solid *solid) {
  tp_message message = {.text = ""};
  tp_sheet_options options = tp_sheet_options_default();
  char path[100];
  options.language = "de";
  snprintf(path, sizeof path, "%s/solid.md", s->folder);
  note_status(s, tp_report_sheet_solid(path, scene, solid, &options, &message), &message);
  say_file(s, path);
}

static void say_solid_of_scene(sayings *s) {
  tp_solid *solid = NULL;
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  tp_status status = tp_scene_read(&scene, EXAMPLE("solids/balanced_rock.yaml"), &message);
  note_number(s, tp_scene_is_solid(scene));
  if (status == TP_OK) status = tp_solve_solid(&solid, scene, &message);
  note_status(s, status, &message);
  note_number(s, tp_solid_is_undecided(solid));
  note_number(s, (long)tp_solid_meets(solid, 1.5));
  const tp_solid_safety *safety = tp_solid_safety_of(solid);
  note_number(s, safety == NULL ? -1 : (long)safety->motion);
  if (solid != NULL && tp_report_solid_row_csv(next_saying(s), solid) != TP_OK) s->count--;
  if (solid != NULL) {
    say_solid_figure(s, solid);
    say_solid_sheet(s, scene, solid);
  }
  tp_solid_free(solid);
  tp_scene_free(scene);
}

void say_solids(sayings *s) {
  static const char *const files[] = {EXAMPLE("solids/balanced_rock.obj"),
                                      EXAMPLE("meshes/hollow_block.obj")};
  for (size_t k = 0; k < 2; k++) {
    tp_solid *solid = NULL;
    tp_message message = {.text = ""};
    tp_solid_options options = tp_solid_options_default();
    options.friction_angle_deg = 30.5;
    options.unit_weight_kn_m3 = 26.5;
    note_status(s, tp_solid_of_file(&solid, files[k], &options, &message), &message);
    if (solid == NULL) continue;
    if (tp_report_solid(next_saying(s), solid) != TP_OK) s->count--;
    if (tp_report_solid_json(next_saying(s), solid) != TP_OK) s->count--;
    if (tp_report_solid_csv(next_saying(s), solid) != TP_OK) s->count--;
    const tp_status cut = tp_report_solid_section(next_saying(s), solid, 45, &message);
    if (cut != TP_OK) s->count--;
    note_status(s, cut, &message);
    tp_solid_free(solid);
  }
  say_solid_of_scene(s);
}
