/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scene files: read, solved, reported. The examples' folder is where the files lie that a scene may
 * name. */

#include "fuzz.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = fuzz_text(data, size);
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  tp_status status = tp_scene_read_text(&scene, text, FUZZ_EXAMPLES "/scene.yaml", &message);
  fuzz_judge(status, scene, &message);
  if (status == TP_OK) {
    const tp_solve_options options = tp_solve_options_default();
    status = tp_solve(&solution, scene, &options, &message);
    fuzz_judge(status, solution, &message);
  }
  if (status == TP_OK) fuzz_report(solution);
  tp_solution_free(solution);
  tp_scene_free(scene);
  free(text);
  return 0;
}
