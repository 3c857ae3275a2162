/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The combinations in order, of equal ones the first. */

#include "stability/combinations.h"

#include "common/notes.h"
#include "scene/partial_factors.h"
#include "stability/severity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool tp_combinations_asked(const tp_scene *scene) {
  return scene->partial_factors != NULL && !scene->factored;
}

static bool is_worse(const tp_solution *one, const tp_solution *other) {
  return tp_severity_compare(tp_severity_of(one->cases + tp_severity_worst(one)),
                             tp_severity_of(other->cases + tp_severity_worst(other))) < 0;
}

/* "DA1-2: weight × 1, water × 1, …; the worst of 2 combinations: water unfavourable" */
static tp_status tell(tp_solution *solution, const tp_scene *scene, unsigned combination,
                      unsigned solved, tp_message *message) {
  enum { SIZE = 900 };
  char which[TP_COMBINATION_TEXT];
  const char *name = scene->partial_factors->name;
  char *factors = tp_factored_text(scene, combination);
  char *text = calloc(1, SIZE);
  if (factors != NULL && text != NULL) {
    snprintf(text, SIZE, "%s: %s", name != NULL ? name : "own", factors);
    const size_t used = strlen(text);
    if (solved > 1) {
      tp_combination_text(which, sizeof which, scene, combination);
      snprintf(text + used, SIZE - used, "; the worst of %u combinations: %s", solved, which);
    }
  }
  const bool told = factors != NULL && text != NULL;
  free(factors);
  solution->partial_factors = text;
  solution->combination = combination;
  if (!told) return tp_fail_memory(message, "the partial factors");
  return tp_notes_add(&solution->notes, message, TP_NOTE, scene->partial_factors->place,
                      "with partial factors %s; numbers are of the factored scene", text);
}

tp_status tp_combinations_solve(tp_solution **solution, const tp_scene *scene,
                                const tp_solve_options *options, tp_combination_solve *solve,
                                tp_message *message) {
  tp_solution *worst = NULL;
  unsigned governing = 0, solved = 0;
  tp_status status = TP_OK;
  for (unsigned k = 0; k < TP_COMBINATIONS && status == TP_OK; k++) {
    tp_scene factored;
    tp_solution *own = NULL;
    if (!tp_combination_differs(scene, k)) continue;
    status = tp_factored_init(&factored, scene, k, message);
    if (status != TP_OK) break;
    status = solve(&own, &factored, options, message);
    tp_factored_clear(&factored);
    if (status != TP_OK) break;
    solved++;
    if (worst == NULL || is_worse(own, worst)) {
      tp_solution_free(worst);
      worst = own;
      governing = k;
    } else {
      tp_solution_free(own);
    }
  }
  if (status == TP_OK) status = tell(worst, scene, governing, solved, message);
  if (status == TP_OK) {
    *solution = worst;
  } else {
    tp_solution_free(worst);
  }
  return status;
}
