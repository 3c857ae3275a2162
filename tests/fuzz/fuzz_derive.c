/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scene files: closed formulas, in every way that they are asked for; the first byte says which. */

#include "fuzz.h"

#include <stdlib.h>

static void derive(const tp_scene *scene, unsigned asked) {
  tp_derivation *derivation = NULL;
  tp_message message = {.text = ""};
  const tp_derive_options options = {.size = sizeof options,
                                     .notation = (tp_notation)(asked % 3),
                                     .elements = asked / 3 % 2 != 0,
                                     .rounded = asked / 6 % 2 != 0,
                                     .limit = asked / 12 % 2 != 0};
  const tp_status status = tp_derive(&derivation, scene, &options, &message);
  fuzz_judge(status, derivation, &message);
  if (status == TP_OK) fuzz_report_derivation(derivation);
  tp_derivation_free(derivation);
}

static void derive_family(const tp_scene *scene, unsigned asked) {
  tp_family *family = NULL;
  tp_message message = {.text = ""};
  char *text = NULL;
  const tp_status status = tp_derive_family(&family, scene, (tp_notation)(asked % 3), &message);
  fuzz_judge(status, family, &message);
  if (status == TP_OK) {
    FUZZ_EXPECT(tp_report_family(&text, family) == TP_OK);
    free(text);
    FUZZ_EXPECT(tp_report_family_json(&text, family) == TP_OK);
    free(text);
  }
  tp_family_free(family);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size == 0) return -1;
  char *text = fuzz_text(data + 1, size - 1);
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read_text(&scene, text, FUZZ_EXAMPLES "/scene.yaml", &message);
  fuzz_judge(status, scene, &message);
  if (status == TP_OK && data[0] < 0xe0) derive(scene, data[0]);
  if (status == TP_OK && data[0] >= 0xe0) derive_family(scene, data[0]);
  tp_scene_free(scene);
  free(text);
  return 0;
}
