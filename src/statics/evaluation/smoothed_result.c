/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was levelled of a sole, as results: exact rationals. */

#include "evaluation/certainty.h"
#include "evaluation/stages.h"

static tp_bounded metres(const tp_scene *scene, const fmpq_t length) {
  fmpq_t value;
  fmpq_init(value);
  fmpq_mul(value, length, scene->metres_per_unit);
  const tp_bounded result = tp_result_rational(value);
  fmpq_clear(value);
  return result;
}

void tp_describe_smoothed(tp_solution *solution, const tp_problem *problem) {
  const tp_smoothed *own = problem->placement.smoothed;
  if (own == NULL) return;
  const tp_scene *scene = &own->scene;
  solution->smoothed = (tp_smoothed_result){.known = true,
                                            .apparent = own->all,
                                            .facets = (size_t)own->levelled,
                                            .stretches = (size_t)own->stretches,
                                            .farthest_m = metres(scene, own->farthest)};
  if (!own->all) solution->smoothed.wavelength_m = metres(scene, scene->base.smooth.value);
}
