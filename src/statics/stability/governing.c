/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which factor of safety governs (topple_governing.h)? The least of those that count, by the rule
 * that all forms of a scene share (verdict/safety.h). Of numbers whose bounds overlap the first is
 * named: a formula of the field before the factor of the onset that it is. */

#include "stability/governing.h"
#include "common/host.h"
#include "evaluation/certainty.h"
#include "number/bounded.h"
#include "scene/partial_factors.h"
#include "stability/governing_factors.h"
#include "verdict/safety.h"

#include <math.h>

/* ---- which governs -----------------------------------------------------------------------------
 */

static bool overlap(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

static tp_motion_verdict verdict_of(const tp_case *c) {
  switch (c->mechanism) {
  case TP_STANDS:
  case TP_INTERLOCKED:
    return TP_VERDICT_STANDS;
  case TP_MAY_MOVE:
    return TP_VERDICT_CAN_MOVE;
  case TP_MECHANISM_UNDECIDED:
    return TP_VERDICT_OPEN;
  default:
    return TP_VERDICT_COLLAPSES;
  }
}

/* Where the onset was not asked for nothing says that another motion does not begin before. */
static bool is_asked(const tp_case *c) {
  return c->onset.kind != TP_ONSET_NOT_ASKED;
}

/* The bounds of the factor, from those that count. */
static tp_safety bounds_of(const tp_governing_fos *g, tp_motion_verdict verdict) {
  tp_factor_range ranges[TP_FACTORS_MAX];
  size_t count = 0;
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *f = g->factors + k;
    if (f->counts) ranges[count++] = tp_factor_range_of(f->definition, f->mechanism, f->fos);
  }
  return tp_safety_of(verdict, ranges, count);
}

/* Names the first of the factors that count whose upper bound is the least, as far as their bounds
 * decide. */
static void name_least(tp_governing_fos *g) {
  const tp_factor *least = NULL;
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *f = g->factors + k;
    if (!f->counts || tp_fos_rank_of(f->fos) == TP_RANK_UNDECIDED) continue;
    if (least == NULL || tp_fos_is_less(f->fos, least->fos)) least = f;
  }
  for (size_t k = 0; k < g->factor_count && least != NULL; k++) {
    const tp_factor *f = g->factors + k;
    const bool number = tp_fos_rank_of(least->fos) == TP_RANK_NUMBER;
    const bool same = f == least || (f->counts && number && f->fos.state == TP_FOS_NUMBER &&
                                     overlap(f->fos.value, least->fos.value));
    if (!same) continue;
    g->tie = g->has_factor && (g->tie || f->mechanism != g->factors[g->factor].mechanism);
    if (!g->has_factor) g->factor = k;
    g->has_factor = true;
  }
}

/* The number that governs: that of the factor which is named, or what encloses all that overlap. */
static tp_fos fos_of(const tp_governing_fos *g, const tp_safety *safety) {
  const tp_fos all = tp_safety_fos(safety);
  if (!g->has_factor || all.state != TP_FOS_NUMBER) return all;
  const tp_fos named = g->factors[g->factor].fos;
  const double high = named.value.value + named.value.error;
  const double low = named.value.value - named.value.error;
  const bool is_it = named.state == TP_FOS_NUMBER && nextafter(low, -INFINITY) <= safety->least &&
                     high <= nextafter(safety->most, INFINITY);
  return is_it ? named : all;
}

static void add_utilisation(tp_governing_fos *g) {
  const tp_bounded one = {.value = 1};
  const bool is_number = g->fos.state == TP_FOS_NUMBER && g->fos.value.value > g->fos.value.error;
  g->has_utilisation = is_number && g->complete;
  if (g->has_utilisation) g->utilisation = tp_bounded_over(one, g->fos.value);
}

/* Are all factors that count above 1? What moves at a lesser tilt does not come to this one, though
 * forces would hold it here: under loads that do not turn with it, or friction that grows as the
 * stress falls. */
static bool are_above(const tp_governing_fos *g) {
  bool above = g->factor_count > 0;
  for (size_t k = 0; k < g->factor_count; k++) {
    above = above && (!g->factors[k].counts || tp_fos_is_above(g->factors[k].fos));
  }
  return above;
}

/* Sets what follows from the factors: their bounds, the number, and which of them it is. */
static void take_bounds(tp_governing_fos *g, tp_safety safety) {
  /* a factor that was not asked for is no number, but may be less */
  g->at_least =
      g->complete ? safety.least : fmin(safety.least, safety.verdict == TP_VERDICT_STANDS ? 1 : 0);
  g->at_most = safety.most;
  g->has_factor = g->tie = false;
  name_least(g);
  g->fos = fos_of(g, &safety);
  add_utilisation(g);
}

static void govern(tp_case *c, const tp_solution *solution) {
  tp_governing_fos *g = &c->governing_fos;
  const tp_fos known[] = {c->onset.fos, c->onset.fos_driving};
  *g = (tp_governing_fos){.fos = {.state = TP_FOS_NO_TILT},
                          .sliding_judged = solution->has_friction,
                          .complete = solution->has_friction && is_asked(c),
                          .at_most = INFINITY};
  c->has_tilt_of_factor = false;
  if (!solution->has_tilt_angle) return;
  const tp_at_scene at = tp_at_scene_of(c, solution);
  tp_governing_add_factors(g, &at);
  for (int k = 0; k < 2; k++) {
    const tp_fos_rank rank = tp_fos_rank_of(known[k]);
    if (rank == TP_RANK_UNDECIDED || rank == TP_RANK_ABSENT) g->complete = false;
  }
  c->has_tilt_of_factor = is_asked(c) && tp_governing_tilt(&c->tilt_of_factor_deg, &at);
  if (!is_asked(c) && (c->falls_backwards || g->factor_count == 0)) {
    g->fos.state = c->falls_backwards ? TP_FOS_UNDEFINED : TP_FOS_NOT_ASKED;
    g->up_dip = c->falls_backwards;
    return;
  }
  take_bounds(g, bounds_of(g, is_asked(c) ? verdict_of(c) : TP_VERDICT_OPEN));
  g->beyond = at.moves && !c->falls_backwards && are_above(g);
  if (g->beyond) {
    g->fos = (tp_fos){.state = TP_FOS_UNDEFINED};
    g->has_factor = false;
  }
  g->up_dip = c->falls_backwards && g->fos.state == TP_FOS_UNDEFINED;
}

/* Of moments alone, whether other forces would prevent the turning or not; sliding is not asked. */
static void take_toppling_alone(tp_case *c) {
  tp_governing_fos *g = &c->governing_fos;
  g->sliding_judged = g->complete = true;
  for (size_t k = 0; k < g->factor_count; k++) {
    tp_factor *f = g->factors + k;
    f->counts = f->definition == TP_FOS_BY_MOMENTS;
    if (!f->counts) continue;
    f->standing = TP_FACTOR_COUNTS;
    if (tp_fos_rank_of(f->fos) == TP_RANK_UNDECIDED) g->complete = false;
  }
  take_bounds(g, bounds_of(g, TP_VERDICT_OPEN));
}

void tp_solution_govern(tp_solution *solution, const tp_scene *scene) {
  const bool alone = scene->factored && scene->partial_factors->toppling_alone;
  for (size_t k = 0; k < solution->case_count; k++) {
    tp_governing_fos *g = &solution->cases[k].governing_fos;
    govern(solution->cases + k, solution);
    if (alone && g->fos.state != TP_FOS_NO_TILT) take_toppling_alone(solution->cases + k);
    g->has_required_fos = scene->required_fos.given;
    g->required_fos = tp_result_rational(scene->required_fos.value);
    g->meets_required = tp_case_meets(solution->cases + k, g->required_fos.value);
    g->has_design_utilisation = g->has_required_fos && g->has_utilisation;
    if (g->has_design_utilisation) {
      g->design_utilisation = tp_bounded_over(g->required_fos, g->fos.value);
    }
  }
}

tp_safety tp_case_safety(const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  return (tp_safety){.verdict = verdict_of(c), .least = g->at_least, .most = g->at_most};
}

void tp_case_add_state(tp_case *c, const tp_safety *other) {
  tp_governing_fos *g = &c->governing_fos;
  const bool is_less = other->least < g->at_least || other->most < g->at_most;
  if (verdict_of(c) < TP_VERDICT_OPEN || g->fos.state == TP_FOS_NO_TILT || !is_less) return;
  g->at_least = fmin(g->at_least, other->least);
  g->at_most = fmin(g->at_most, other->most);
  const tp_safety both = tp_case_safety(c);
  const bool is_known = tp_safety_fos(&both).state != TP_FOS_UNDECIDED;
  const bool is_above =
      g->fos.state == TP_FOS_NUMBER && g->fos.value.value > both.most * (1 + TP_SAFETY_WIDTH);
  if (is_known && !is_above) return; /* the same to all digits that are proven */
  g->fos = (tp_fos){.state = TP_FOS_UNDECIDED};
  g->complete = g->has_utilisation = g->has_design_utilisation = false;
  g->meets_required = tp_case_meets(c, g->required_fos.value);
}

tp_design tp_case_meets(const tp_case *c, double design_fos) {
  TP_GUARD_HOST;
  if (c == NULL) return TP_DESIGN_OPEN;
  const tp_governing_fos *g = &c->governing_fos;
  if (!g->sliding_judged || g->fos.state == TP_FOS_NO_TILT || g->fos.state == TP_FOS_NOT_ASKED) {
    return isnan(design_fos) ? TP_DESIGN_OPEN : TP_DESIGN_NOT_MET;
  }
  const tp_safety safety = tp_case_safety(c);
  return tp_safety_meets(&safety, design_fos);
}

tp_design tp_solution_meets(const tp_solution *solution, double design_fos) {
  TP_GUARD_HOST;
  if (solution == NULL || isnan(design_fos)) return TP_DESIGN_OPEN;
  tp_design all = TP_DESIGN_MET;
  for (size_t k = 0; k < solution->case_count; k++) {
    const tp_design own = tp_case_meets(solution->cases + k, design_fos);
    if (own == TP_DESIGN_NOT_MET) return own;
    if (own == TP_DESIGN_OPEN) all = own;
  }
  return all;
}
