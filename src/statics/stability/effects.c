/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* List of effects with the input that called for each and the elapsed time, without that of other
 * effects noted meanwhile. */

#include "stability/effects.h"
#include "common/clock.h"

#include <stdlib.h>
#include <string.h>

static double noted(const tp_solution *solution) {
  double seconds = 0;
  for (size_t k = 0; k < solution->effect_count; k++) seconds += solution->effects[k].seconds;
  return seconds;
}

tp_effect_begin tp_effects_begin(const tp_solution *solution) {
  return (tp_effect_begin){tp_clock_now(), noted(solution)};
}

bool tp_effects_note(tp_solution *solution, const char *name, tp_place place, const char *instead,
                     tp_effect_begin since) {
  const double all = tp_clock_now() - since.now, others = noted(solution) - since.noted;
  /* the sums are rounded */
  return tp_effects_add(solution, name, place, instead, all > others ? all - others : 0);
}

/* For one more: a scene has some ten of them. */
static bool make_room(tp_solution *solution) {
  enum { STEP = 12 };
  if (solution->effect_count % STEP != 0) return true;
  tp_effect *more =
      realloc(solution->effects, (solution->effect_count + STEP) * sizeof *solution->effects);
  if (more == NULL) return false;
  solution->effects = more;
  return true;
}

bool tp_effects_add(tp_solution *solution, const char *name, tp_place place, const char *instead,
                    double seconds) {
  for (size_t k = 0; k < solution->effect_count; k++) {
    if (strcmp(solution->effects[k].name, name) != 0) continue;
    solution->effects[k].seconds += seconds;
    return true;
  }
  if (!make_room(solution)) return false;
  char *by = place.file != NULL ? tp_place_new(place) : strdup(instead);
  if (by == NULL) return false;
  solution->effects[solution->effect_count++] =
      (tp_effect){.name = name, .called_for_by = by, .seconds = seconds, .level = TP_LEVEL_EXACT};
  return true;
}

tp_status tp_effects_entered(tp_status status, tp_message *message, bool noted) {
  return status == TP_OK && !noted ? tp_fail_memory(message, "the effects") : status;
}

void tp_effects_clear(tp_solution *solution) {
  for (size_t k = 0; k < solution->effect_count; k++) free(solution->effects[k].called_for_by);
  free(solution->effects);
}
