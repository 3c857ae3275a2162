/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Transformation of independent scores by the copula and the marginal distributions, and the call
 * of the limit-state function at many points. */

#include "statistics/standard_space.h"

#include "sampling/copula.h"

#include <stdlib.h>
#include <string.h>

tp_status tp_standard_space_init(tp_standard_space *space, const tp_reliability *problem,
                                 size_t room, tp_message *message) {
  const size_t n = problem->dimensions;
  const bool dependent = problem->correlation != NULL;
  *space = (tp_standard_space){.problem = problem, .room = room};
  space->points = calloc(n * room, sizeof *space->points);
  if (dependent) space->factor = calloc(n * n, sizeof *space->factor);
  tp_status status = TP_OK;
  if (space->points == NULL || (dependent && space->factor == NULL)) {
    status = tp_fail_memory(message, "a problem of reliability");
  } else if (dependent) {
    status = tp_copula_factor(space->factor, problem->correlation, n, NULL, message);
  }
  if (status != TP_OK) tp_standard_space_clear(space);
  return status;
}

void tp_standard_space_clear(tp_standard_space *space) {
  free(space->factor);
  free(space->points);
  space->factor = space->points = NULL;
}

void tp_standard_space_point(const tp_standard_space *space, double *x, const double *z) {
  const size_t n = space->problem->dimensions;
  memcpy(x, z, n * sizeof *x);
  if (space->factor != NULL) tp_copula_apply(space->factor, n, x);
  for (size_t i = 0; i < n; i++) {
    x[i] = tp_distribution_at_score(space->problem->variables + i, x[i]);
  }
}

tp_status tp_standard_space_values(tp_standard_space *space, double *g, const double *z,
                                   size_t count, tp_message *message) {
  const tp_reliability *p = space->problem;
  for (size_t k = 0; k < count; k++) {
    tp_standard_space_point(space, space->points + k * p->dimensions, z + k * p->dimensions);
  }
  space->calls += count;
  return p->limit_state(g, p->context, space->points, count, message);
}
