/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rank and need of a result, compared. */

#include "stability/severity.h"

#include <math.h>

static int rank_of(const tp_case *own) {
  const tp_governing_fos *g = &own->governing_fos;
  const tp_design met = g->has_required_fos ? g->meets_required : tp_case_meets(own, 0);
  return met == TP_DESIGN_NOT_MET ? 2 : met == TP_DESIGN_OPEN ? 1 : 0;
}

tp_severity tp_severity_of(const tp_case *own) {
  const tp_governing_fos *g = &own->governing_fos;
  const double required = g->has_required_fos ? g->required_fos.value : 1;
  const bool number = g->fos.state == TP_FOS_NUMBER && g->fos.value.value > 0;
  const double need = number                                  ? required / g->fos.value.value
                      : g->fos.state == TP_FOS_NO_OVERTURNING ? 0
                                                              : INFINITY;
  return (tp_severity){rank_of(own), need};
}

int tp_severity_compare(tp_severity one, tp_severity other) {
  if (one.rank != other.rank) return other.rank - one.rank;
  return one.need > other.need ? -1 : one.need < other.need;
}

size_t tp_severity_worst(const tp_solution *solution) {
  size_t worst = 0;
  for (size_t k = 1; k < solution->case_count; k++) {
    const tp_severity own = tp_severity_of(solution->cases + k);
    if (tp_severity_compare(own, tp_severity_of(solution->cases + worst)) < 0) worst = k;
  }
  return worst;
}
