/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The combinations in order, of equal ones the first. */

#include "stability/combinations.h"

#include "scene/partial_factors.h"
#include "stability/severity.h"

bool tp_combinations_asked(const tp_scene *scene) {
  return scene->partial_factors != NULL && !scene->factored;
}

static bool is_worse(const tp_solution *one, const tp_solution *other) {
  return tp_severity_compare(tp_severity_of(one->cases + tp_severity_worst(one)),
                             tp_severity_of(other->cases + tp_severity_worst(other))) < 0;
}

static tp_status tell(tp_solution *solution, const tp_scene *scene, unsigned combination,
                      unsigned solved, tp_message *message) {
  solution->partial_factors = tp_factored_text(scene, combination, solved);
  solution->combination = combination;
  return tp_factored_note(&solution->notes, scene, solution->partial_factors, message);
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
