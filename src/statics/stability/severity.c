/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rank and need of a result, compared. */

#include "stability/severity.h"

#include "stability/governing.h"

#include <math.h>

/* By the verdict, and of those that stand by what is required. */
static int rank_of(const tp_case *c) {
  enum { UNSTABLE = 4, UNDECIDED = 2 };
  const tp_governing_fos *g = &c->governing_fos;
  const tp_motion_verdict verdict = tp_case_safety(c).verdict;
  if (verdict == TP_VERDICT_OPEN) return UNDECIDED;
  if (verdict != TP_VERDICT_STANDS) return UNSTABLE - (int)verdict;
  return g->has_required_fos && g->meets_required == TP_DESIGN_NOT_MET ? 1 : 0;
}

tp_severity tp_severity_of(const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  const double required = g->has_required_fos ? g->required_fos.value : 1;
  const double most = g->at_most > 0 ? required / g->at_most : INFINITY;
  const double least = g->at_least > 0 ? required / g->at_least : INFINITY;
  return (tp_severity){rank_of(c), most, least};
}

int tp_severity_compare(tp_severity one, tp_severity other) {
  if (one.rank != other.rank) return other.rank - one.rank;
  if (one.need != other.need) return one.need > other.need ? -1 : 1;
  return one.most_need > other.most_need ? -1 : one.most_need < other.most_need;
}

size_t tp_severity_worst(const tp_solution *solution) {
  size_t worst = 0;
  for (size_t k = 1; k < solution->case_count; k++) {
    const tp_severity own = tp_severity_of(solution->cases + k);
    if (tp_severity_compare(own, tp_severity_of(solution->cases + worst)) < 0) worst = k;
  }
  return worst;
}
