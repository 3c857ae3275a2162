/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The library's calls on a drawn scene with drawn options, wrong ones among them. */

#include "fuzz.h"

#include <stdlib.h>

static void solve(const tp_scene *scene, fuzz_bytes *b) {
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  tp_solve_options options = tp_solve_options_default();
  const unsigned asked = fuzz_pick(b, 8);
  options.elements = (asked & 1) != 0;
  options.limit = (asked & 2) == 0;
  options.strength_reduction = (asked & 4) == 0;
  /* more than fifty digits take longer, not other ways */
  if (fuzz_pick(b, 2) != 0) options.digits = (int)fuzz_pick(b, 52) - 1;
  if (fuzz_pick(b, 4) == 3) options.level = (tp_level)fuzz_pick(b, TP_LEVEL_EXACT + 1);
  const tp_status status = tp_solve(&solution, scene, &options, &message);
  fuzz_judge(status, solution, &message);
  if (status == TP_OK) fuzz_report(solution);
  tp_solution_free(solution);
}

static void derive(const tp_scene *scene, fuzz_bytes *b) {
  tp_derivation *derivation = NULL;
  tp_message message = {.text = ""};
  const unsigned asked = fuzz_pick(b, 8);
  const tp_derive_options options = {.size = sizeof options,
                                     .notation = (tp_notation)fuzz_pick(b, 3),
                                     .elements = (asked & 1) != 0,
                                     .rounded = (asked & 2) != 0,
                                     .limit = (asked & 4) != 0};
  const tp_status status = tp_derive(&derivation, scene, &options, &message);
  fuzz_judge(status, derivation, &message);
  if (status == TP_OK) fuzz_report_derivation(derivation);
  tp_derivation_free(derivation);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  const unsigned call = fuzz_pick(&bytes, 4);
  char *text = fuzz_scene(&bytes);
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read_text(&scene, text, "drawn.yaml", &message);
  fuzz_judge(status, scene, &message);
  if (status == TP_OK && call < 3) solve(scene, &bytes);
  if (status == TP_OK && call == 3) derive(scene, &bytes);
  tp_scene_free(scene);
  free(text);
  return 0;
}
