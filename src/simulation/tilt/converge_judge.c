/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Convergence of a tilt test in its settings: the levels of one setting are compared, and their
 * spread against the width asked for decides between holds, refined, not converged and undecided
 * (docs/tilt_converge.md). */

#include "tilt/converge.h"

#include <math.h>

/* What must agree of two brackets: all of both; of brackets whose width is what is varied, how far
 * they are apart. */
static double apart(const tp_converge_level *a, const tp_converge_level *b) {
  if (a->setting == TP_CONVERGE_TOLERANCE) {
    return fmax(0,
                fmax(a->bracket_least, b->bracket_least) - fmin(a->bracket_most, b->bracket_most));
  }
  return fmax(a->bracket_most, b->bracket_most) - fmin(a->bracket_least, b->bracket_least);
}

/* The largest of a level against those behind it. */
static double spread_from(const tp_converge_level *levels, size_t from, size_t count) {
  double spread = 0;
  for (size_t k = from; k + 1 < count; k++) {
    for (size_t j = k + 1; j < count; j++) {
      spread = fmax(spread, apart(levels + k, levels + j));
    }
  }
  return spread;
}

bool tp_converge_settled(const tp_converge_level *levels, size_t count, double asked) {
  const tp_converge_level *last = levels + count - 1;
  bool past_own = false;
  if (last->setting == TP_CONVERGE_STIFFNESS_RATIO || last->setting == TP_CONVERGE_TOLERANCE) {
    return false;
  }
  for (size_t k = 0; k + 1 < count; k++) past_own = past_own || levels[k].own;
  return past_own && last->known && last[-1].known && apart(last - 1, last) <= asked;
}

void tp_converge_judge(tp_converge_finding *finding, const tp_converge_level *levels,
                       double asked) {
  const tp_converge_level *own = levels + finding->first;
  const size_t count = finding->count;
  const bool ordered = finding->setting != TP_CONVERGE_STIFFNESS_RATIO;
  size_t set = count, needed = count - 1;
  finding->verdict = TP_CONVERGE_OPEN;
  for (size_t k = 0; k < count; k++) {
    if (!own[k].known) return;
    if (own[k].own) set = k;
  }
  while (needed > 0 && spread_from(own, needed - 1, count) <= asked) needed--;
  if (!ordered) {
    finding->spread = spread_from(own, 0, count);
    finding->verdict = finding->spread <= asked ? TP_CONVERGE_HOLDS : TP_CONVERGE_DEPENDS;
    return;
  }
  finding->has_needed = needed + 1 < count;
  finding->needed = finding->has_needed ? own[needed].value : 0;
  const size_t last = count > 1 ? count - 2 : 0;
  finding->verdict = !finding->has_needed ? TP_CONVERGE_DEPENDS
                     : set >= needed      ? TP_CONVERGE_HOLDS
                                          : TP_CONVERGE_REFINED;
  finding->spread = spread_from(
      own, finding->verdict == TP_CONVERGE_HOLDS ? (set < last ? set : last) : last, count);
}

static void take_in(tp_tilt_convergence_case *own, const tp_converge_level *level) {
  own->over_settings_least = fmin(own->over_settings_least, level->bracket_least);
  own->over_settings_most = fmax(own->over_settings_most, level->bracket_most);
}

/* The finest levels from the last setting on that was refined; what held before stays so. */
void tp_converge_summarise(tp_tilt_convergence_case *own) {
  size_t from = 0;
  own->converged = own->known && own->setting_count > 0;
  own->over_settings_least = own->as_set_least;
  own->over_settings_most = own->as_set_most;
  for (size_t k = 0; k < own->setting_count; k++) {
    const tp_converge_finding *f = own->settings + k;
    own->converged = own->converged && f->verdict <= TP_CONVERGE_REFINED;
    if (f->verdict != TP_CONVERGE_REFINED) continue;
    from = k;
    own->over_settings_least = INFINITY;
    own->over_settings_most = -INFINITY;
  }
  for (size_t k = from; k < own->setting_count; k++) {
    const tp_converge_finding *f = own->settings + k;
    const bool all = f->setting == TP_CONVERGE_STIFFNESS_RATIO;
    if (f->verdict == TP_CONVERGE_OPEN || f->setting == TP_CONVERGE_TOLERANCE) continue;
    for (size_t j = all ? 0 : f->count - 1; j < f->count; j++) {
      take_in(own, own->levels + f->first + j);
    }
  }
}
