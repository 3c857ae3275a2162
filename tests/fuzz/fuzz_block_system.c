/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes of many blocks: read, solved, reported. */

#include "fuzz.h"

#include <stdlib.h>

static void report(const tp_block_system *system) {
  char *text = NULL;
  if (tp_report_block_system(&text, system) == TP_OK) free(text);
  text = NULL;
  if (tp_report_block_system_json(&text, system) == TP_OK) free(text);
  text = NULL;
  if (tp_report_block_system_csv(&text, system) == TP_OK) free(text);
  text = NULL;
  if (tp_report_block_systems_table(&text, &system, 1) == TP_OK) free(text);
  (void)tp_block_system_meets(system, 1.3);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = fuzz_text(data, size);
  tp_scene *scene = NULL;
  tp_block_system *system = NULL;
  tp_message message = {.text = ""};
  tp_status status = tp_scene_read_text(&scene, text, FUZZ_EXAMPLES "/scene.yaml", &message);
  fuzz_judge(status, scene, &message);
  if (status == TP_OK && tp_scene_block_count(scene) > 0) {
    const tp_solve_options options = tp_solve_options_default();
    status = tp_solve_block_system(&system, scene, &options, &message);
    fuzz_judge(status, system, &message);
    if (status == TP_OK) report(system);
  }
  tp_block_system_free(system);
  tp_scene_free(scene);
  free(text);
  return 0;
}
