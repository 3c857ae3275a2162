/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/effects.h"
#include "clock.h"

#include <stdio.h>
#include <string.h>

static double noted(const tp_solution *solution) {
  double seconds = 0;
  for (size_t k = 0; k < solution->effect_count; k++) seconds += solution->effects[k].seconds;
  return seconds;
}

tp_effect_begin tp_effects_begin(const tp_solution *solution) {
  return (tp_effect_begin){tp_clock_now(), noted(solution)};
}

void tp_effects_note(tp_solution *solution, const char *name, tp_place place, const char *instead,
                     tp_effect_begin since) {
  const double all = tp_clock_now() - since.now, others = noted(solution) - since.noted;
  /* the sums are rounded */
  tp_effects_add(solution, name, place, instead, all > others ? all - others : 0);
}

void tp_effects_add(tp_solution *solution, const char *name, tp_place place, const char *instead,
                    double seconds) {
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
