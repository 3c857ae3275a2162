/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rank and need of a result, compared. */

#include "stability/severity.h"

#include "stability/governing.h"

#include <math.h>

tp_severity tp_severity_of_safety(const tp_safety *safety, bool is_required, double required) {
  enum { UNSTABLE = 4, UNDECIDED = 2 };
  const double needed = is_required ? required : 1;
  const bool lacks = is_required && tp_safety_meets(safety, required) == TP_DESIGN_NOT_MET;
  tp_severity severity = {lacks, safety->most > 0 ? needed / safety->most : INFINITY,
                          safety->least > 0 ? needed / safety->least : INFINITY};
  if (safety->verdict == TP_VERDICT_OPEN) severity.rank = UNDECIDED;
  if (safety->verdict < TP_VERDICT_OPEN) severity.rank = UNSTABLE - (int)safety->verdict;
  return severity;
}

tp_severity tp_severity_of(const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  const tp_safety safety = tp_case_safety(c);
  return tp_severity_of_safety(&safety, g->has_required_fos, g->required_fos.value);
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
