/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _POSIX_C_SOURCE 200809L
#include "stability/effects.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

double tp_effects_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void tp_effects_note(tp_solution *solution, const char *name, tp_place place, const char *instead,
                     double since) {
  const double seconds = tp_effects_now() - since;
  for (size_t k = 0; k < solution->effect_count; k++) {
    if (strcmp(solution->effects[k].name, name) != 0) continue;
    solution->effects[k].seconds += seconds;
    return;
  }
  if (solution->effect_count == TP_EFFECTS_MAX) return;
  tp_effect *effect = solution->effects + solution->effect_count++;
  effect->name = name;
  effect->seconds = seconds;
  effect->level = TP_LEVEL_EXACT;
  if (place.file != NULL) {
    tp_place_text(effect->called_for_by, sizeof effect->called_for_by, place);
  } else {
    snprintf(effect->called_for_by, sizeof effect->called_for_by, "%s", instead);
  }
}
