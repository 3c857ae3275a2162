/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which factor of safety governs (topple_governing.h)?
 *
 * About an admissible pivot the one by moments; along the facet that slides that of shear strength,
 * and for a rough base the one with phi + i as strength on the mean plane; of all motions that
 * contact forces allow the one by strength. A factor below 1 counts only where its motion is among
 * those that can begin at the tilt, and one above 1 only where a motion can begin at the tilt at
 * which it comes to 1: else contact forces prevent it.
 *
 * Where a motion can begin, two things would stop it: a change of strength, and of what drives
 * those ways that begin whatever the strength. The nearer governs, so that the factor is 1 where
 * the motion begins. Of a tilt at which motions begin or end for neither reason, as where a contact
 * opens, the tilt itself tells. Of numbers that their bounds do not tell apart, that which governs
 * lies in the enclosure of both, and the first is named. */

#include "stability/governing.h"
#include "common/host.h"
#include "evaluation/certainty.h"
#include "number/bounded.h"
#include "scene/partial_factors.h"
#include "stability/governing_factors.h"

#include <math.h>

/* ---- which governs -----------------------------------------------------------------------------
 */

/* The least of two numbers lies between the lesser of their lower and of their upper ends. */
static tp_bounded lesser(tp_bounded a, tp_bounded b) {
  const double low_a = a.value - a.error, high_a = a.value + a.error;
  const double low_b = b.value - b.error, high_b = b.value + b.error;
  if (low_a <= low_b && high_a <= high_b) return a;
  if (low_b <= low_a && high_b <= high_a) return b;
  const double low = nextafter(fmin(low_a, low_b), -INFINITY); /* their sums were rounded */
  const double high = nextafter(fmin(high_a, high_b), INFINITY);
  const double value = low + (high - low) / 2;
  return (tp_bounded){.value = value,
                      .error = nextafter(fmax(value - low, high - value), INFINITY)};
}

static bool overlap(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

static tp_bounded larger(tp_bounded a, tp_bounded b) {
  a.value = -a.value;
  b.value = -b.value;
  tp_bounded least = lesser(a, b);
  least.value = -least.value;
  return least;
}

static void take(tp_governing_fos *g, size_t k) {
  g->has_factor = true;
  g->factor = k;
  g->fos = g->factors[k].fos;
}

/* The least of those that count; of a block that moves, of those that are not above 1, without
 * those by strength and by the tilt. */
static void take_least(tp_governing_fos *g, bool moves) {
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *own = g->factors + k;
    if (!own->counts) continue;
    if (tp_fos_rank_of(own->fos) == TP_RANK_UNDECIDED) g->complete = false;
    if (moves && (tp_fos_is_above(own->fos) || own->definition >= TP_FOS_BY_REDUCTION)) continue;
    const tp_factor *held = g->has_factor ? g->factors + g->factor : NULL;
    if (held != NULL && tp_fos_rank_of(own->fos) == TP_RANK_NUMBER &&
        tp_fos_rank_of(held->fos) == TP_RANK_NUMBER) {
      const bool same = overlap(own->fos.value, g->fos.value);
      if (!same && own->fos.value.value > g->fos.value.value) continue;
      g->tie = same && (g->tie || own->mechanism != held->mechanism);
      if (same) {
        g->fos.value = lesser(g->fos.value, own->fos.value);
        continue;
      }
    } else if (held != NULL && !tp_fos_is_less(own->fos, held->fos)) {
      continue;
    }
    take(g, k);
  }
}

static const tp_factor *find(const tp_governing_fos *g, tp_fos_definition definition) {
  for (size_t k = 0; k < g->factor_count; k++) {
    if (g->factors[k].definition == definition) return g->factors + k;
  }
  return NULL;
}

/* Of a block that moves: another factor not above 1, where it is the nearer to 1. */
static void take_if_nearer(tp_governing_fos *g, const tp_factor *own) {
  if (tp_fos_rank_of(own->fos) != TP_RANK_NUMBER) return;
  const bool number = tp_fos_rank_of(g->fos) == TP_RANK_NUMBER;
  if (number && overlap(own->fos.value, g->fos.value)) {
    g->tie = g->tie || own->mechanism != g->factors[g->factor].mechanism;
    g->fos.value = larger(own->fos.value, g->fos.value);
  } else if (!number || own->fos.value.value > g->fos.value.value) {
    g->tie = false;
    take(g, (size_t)(own - g->factors));
  }
}

/* Likewise that by strength; and by the tilt, which is there where nothing else tells. */
static void take_nearer(tp_governing_fos *g) {
  const tp_factor *strength = find(g, TP_FOS_BY_REDUCTION), *tilt = find(g, TP_FOS_BY_TILT);
  if (strength == NULL) {
    if (!g->has_factor) g->fos = (tp_fos){.state = TP_FOS_UNDECIDED};
    return;
  }
  if (tp_fos_is_above(strength->fos)) return;
  if (!g->has_factor) {
    take(g, (size_t)(strength - g->factors));
  } else {
    take_if_nearer(g, strength);
  }
  const bool told = tp_fos_rank_of(strength->fos) != TP_RANK_UNDECIDED;
  if (tilt != NULL && told) take_if_nearer(g, tilt);
}

/* What moves at a lesser tilt does not come to this one, though forces would hold it here: under
 * loads that do not turn with it, or friction that grows as the stress falls. */
static void judge_beyond(tp_governing_fos *g, bool moves) {
  g->beyond = moves && !g->up_dip && (!g->has_factor || tp_fos_is_above(g->fos)) &&
              tp_fos_rank_of(g->fos) != TP_RANK_UNDECIDED;
  if (!g->beyond) return;
  g->fos = (tp_fos){.state = TP_FOS_UNDEFINED};
  g->has_factor = false;
}

static void add_utilisation(tp_governing_fos *g) {
  const tp_bounded one = {.value = 1};
  const bool is_number = g->fos.state == TP_FOS_NUMBER && g->fos.value.value > g->fos.value.error;
  g->has_utilisation = is_number && g->complete;
  if (g->has_utilisation) g->utilisation = tp_bounded_over(one, g->fos.value);
}

static void govern(tp_case *c, const tp_solution *solution) {
  tp_governing_fos *g = &c->governing_fos;
  *g = (tp_governing_fos){.fos = {.state = TP_FOS_NO_TILT},
                          .sliding_judged = solution->has_friction,
                          .complete = solution->has_friction};
  c->has_tilt_of_factor = false;
  if (!solution->has_tilt_angle) return;
  g->fos.state = TP_FOS_NOT_ASKED;
  const tp_at_scene at = tp_at_scene_of(c, solution);
  const tp_contact_result *contact = &solution->contact;
  if (contact->facets > 0 ||
      contact->points > contact->corner_points) { /* else nothing carries it */
    tp_governing_add_formulas(g, &at);
  }
  const bool asked = c->onset.kind != TP_ONSET_NOT_ASKED;
  c->has_tilt_of_factor = asked && tp_governing_add_onset(g, &at, &c->tilt_of_factor_deg);
  if (!asked || c->onset.fos.state == TP_FOS_NOT_ASKED) g->complete = false;
  if (c->falls_backwards && !asked) {
    g->up_dip = true;
    g->fos.state = TP_FOS_UNDEFINED;
    return;
  }
  take_least(g, at.moves);
  if (at.moves) take_nearer(g);
  /* what should hold it drives it: that is no factor of safety */
  if (g->has_factor && tp_fos_rank_of(g->fos) == TP_RANK_NONE)
    g->fos = (tp_fos){.state = TP_FOS_UNDEFINED};
  g->up_dip = c->falls_backwards && g->fos.state == TP_FOS_UNDEFINED;
  judge_beyond(g, at.moves);
  add_utilisation(g);
}

/* Of moments alone, whether other forces would prevent the turning or not; sliding is not asked. */
static void take_toppling_alone(tp_governing_fos *g) {
  g->sliding_judged = g->complete = true;
  g->has_factor = g->tie = false;
  size_t least = g->factor_count;
  for (size_t k = 0; k < g->factor_count; k++) {
    if (g->factors[k].definition != TP_FOS_BY_MOMENTS) continue;
    if (tp_fos_rank_of(g->factors[k].fos) == TP_RANK_UNDECIDED) g->complete = false;
    if (least == g->factor_count || tp_fos_is_less(g->factors[k].fos, g->factors[least].fos)) {
      least = k;
    }
  }
  if (least < g->factor_count) {
    take(g, least);
  } else if (tp_fos_rank_of(g->fos) == TP_RANK_NUMBER) {
    g->fos = (tp_fos){.state = TP_FOS_NOT_ASKED};
  }
  add_utilisation(g);
}

void tp_solution_govern(tp_solution *solution, const tp_scene *scene) {
  const bool alone = scene->factored && scene->partial_factors->toppling_alone;
  for (size_t k = 0; k < solution->case_count; k++) {
    tp_governing_fos *g = &solution->cases[k].governing_fos;
    govern(solution->cases + k, solution);
    if (alone && g->fos.state != TP_FOS_NO_TILT) take_toppling_alone(g);
    g->has_required_fos = scene->required_fos.given;
    g->required_fos = tp_result_rational(scene->required_fos.value);
    g->meets_required = tp_case_meets(solution->cases + k, g->required_fos.value);
    g->has_design_utilisation = g->has_required_fos && g->has_utilisation;
    if (g->has_design_utilisation) {
      g->design_utilisation = tp_bounded_over(g->required_fos, g->fos.value);
    }
  }
}

/* Of a factor alone, whatever the mechanism. */
static tp_design meets(const tp_governing_fos *g, double design_fos) {
  if (!g->sliding_judged) return TP_DESIGN_NOT_MET;
  switch (tp_fos_rank_of(g->fos)) {
  case TP_RANK_NONE:
  case TP_RANK_ABSENT:
    return TP_DESIGN_NOT_MET;
  case TP_RANK_UNDECIDED:
    return TP_DESIGN_OPEN;
  case TP_RANK_UNBOUNDED:
    return g->complete ? TP_DESIGN_MET : TP_DESIGN_OPEN;
  case TP_RANK_NUMBER:
    break;
  }
  const tp_bounded fos = g->fos.value;
  if (fos.value + fos.error < design_fos) return TP_DESIGN_NOT_MET;
  return g->complete && fos.value - fos.error >= design_fos ? TP_DESIGN_MET : TP_DESIGN_OPEN;
}

tp_design tp_case_meets(const tp_case *c, double design_fos) {
  TP_GUARD_HOST;
  if (c == NULL || isnan(design_fos)) return TP_DESIGN_OPEN;
  const tp_design by_factor = meets(&c->governing_fos, design_fos);
  if (by_factor == TP_DESIGN_NOT_MET) return by_factor;
  if (c->mechanism == TP_MECHANISM_UNDECIDED || c->onset.kind == TP_ONSET_UNDECIDED) {
    return TP_DESIGN_OPEN;
  }
  return c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED ? by_factor
                                                                     : TP_DESIGN_NOT_MET;
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
