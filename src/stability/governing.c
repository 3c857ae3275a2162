/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which factor of safety? The least over the ways in which the block can move (topple_governing.h).
 *
 * About each admissible pivot the one by moments; along the facet that slides, where no other
 * stands in the way, that of shear strength, and for a rough base the one with phi + i as strength
 * on the mean plane; of all that contact forces allow the one by strength reduction. Of numbers
 * that their bounds do not tell apart, the least lies in the enclosure of both, and the first is
 * named. */

#include "stability/governing.h"
#include "host.h"

#include <math.h>

const char *tp_fos_definition_name(tp_fos_definition definition) {
  switch (definition) {
  case TP_FOS_BY_MOMENTS:
    return "moments";
  case TP_FOS_BY_SHEAR:
    return "shear strength";
  case TP_FOS_BY_ROUGHNESS:
    return "shear strength with roughness";
  case TP_FOS_BY_REDUCTION:
    return "strength reduction";
  }
  return "unknown";
}

/* From the least safe on: none at all, a number, unknown, unbounded. */
typedef enum rank { RANK_NONE, RANK_NUMBER, RANK_UNDECIDED, RANK_UNBOUNDED, RANK_ABSENT } rank;

static rank rank_of(tp_fos fos) {
  switch (fos.state) {
  case TP_FOS_NUMBER:
    return fos.value.value < -fos.value.error ? RANK_NONE : RANK_NUMBER;
  case TP_FOS_UNDEFINED:
    return RANK_NONE;
  case TP_FOS_UNDECIDED:
    return RANK_UNDECIDED;
  case TP_FOS_NO_OVERTURNING:
    return RANK_UNBOUNDED;
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
  return RANK_ABSENT;
}

static bool is_less(tp_fos one, tp_fos other) {
  const rank own = rank_of(one), held = rank_of(other);
  if (own != held) return own < held;
  return own == RANK_NUMBER && one.value.value < other.value.value;
}

static void add(tp_governing_fos *g, tp_factor factor) {
  if (rank_of(factor.fos) != RANK_ABSENT) g->factors[g->factor_count++] = factor;
}

/* About the admissible pivot that is the least safe; of those alike the one that governs. */
static void add_moments(tp_governing_fos *g, const tp_case *c) {
  if (!c->has_governing) return;
  size_t least = c->governing;
  for (size_t k = 0; k < c->pivot_count; k++) {
    const tp_pivot *p = c->pivots + k;
    if (p->admissible && is_less(p->fos_resultant, c->pivots[least].fos_resultant)) least = k;
  }
  const size_t toe = c->towards == TP_TOWARDS_LEFT ? 0 : c->pivot_count - 1;
  add(g, (tp_factor){.definition = TP_FOS_BY_MOMENTS,
                     .mechanism = TP_TOPPLES,
                     .pivot = least,
                     .toe = least == toe,
                     .counts = true,
                     .fos = c->pivots[least].fos_resultant});
}

static void add_sliding(tp_governing_fos *g, const tp_case *c, bool loaded) {
  const tp_sliding *s = &c->sliding;
  if (!s->known) return;
  tp_factor factor = {.definition = TP_FOS_BY_SHEAR,
                      .mechanism = TP_SLIDES,
                      .counts = s->opens,
                      .fos = loaded ? s->fos : s->fos_strength};
  add(g, factor);
  const tp_bounded i = s->facet_angle_deg;
  if (loaded || (i.value == 0 && i.error == 0)) return; /* the same */
  factor.definition = TP_FOS_BY_ROUGHNESS;
  factor.fos = s->fos;
  add(g, factor);
}

static void add_reduction(tp_governing_fos *g, const tp_limit *limit) {
  add(g, (tp_factor){.definition = TP_FOS_BY_REDUCTION,
                     .mechanism = limit->fos_mechanism,
                     .counts = true,
                     .fos = limit->fos});
}

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

/* No strength holds a block that topples by its moments: their factor below 1 tells by how much. */
static bool is_told_by_moments(const tp_governing_fos *g, const tp_factor *own) {
  return own->definition == TP_FOS_BY_REDUCTION && own->fos.state == TP_FOS_UNDEFINED &&
         rank_of(g->fos) == RANK_NUMBER && g->fos.value.value + g->fos.value.error < 1;
}

static void take_least(tp_governing_fos *g) {
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *own = g->factors + k;
    if (!own->counts || is_told_by_moments(g, own)) continue;
    if (rank_of(own->fos) == RANK_UNDECIDED) g->complete = false;
    const tp_factor *held = g->has_factor ? g->factors + g->factor : NULL;
    if (held != NULL && rank_of(own->fos) == RANK_NUMBER && rank_of(held->fos) == RANK_NUMBER) {
      const bool same = overlap(own->fos.value, g->fos.value);
      if (!same && own->fos.value.value > g->fos.value.value) continue;
      g->tie = same && (g->tie || own->mechanism != held->mechanism);
      if (same) {
        g->fos.value = lesser(g->fos.value, own->fos.value);
        continue;
      }
    } else if (held != NULL && !is_less(own->fos, held->fos)) {
      continue;
    }
    g->has_factor = true;
    g->factor = k;
    g->fos = own->fos;
  }
  /* what should hold it drives it: that is no factor of safety */
  if (g->has_factor && rank_of(g->fos) == RANK_NONE) g->fos = (tp_fos){.state = TP_FOS_UNDEFINED};
}

/* Under loads that do not turn with it, or friction that grows as the stress falls, a block that
 * lets go may be held again farther on. It does not come there. */
static bool lets_go_before(const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  const bool moves = c->mechanism == TP_SLIDES || c->mechanism == TP_TOPPLES ||
                     c->mechanism == TP_SLIDES_AND_TOPPLES || c->mechanism == TP_LEAVES_BASE;
  const bool above =
      rank_of(g->fos) == RANK_UNBOUNDED ||
      (rank_of(g->fos) == RANK_NUMBER && g->fos.value.value - g->fos.value.error > 1);
  const tp_bounded margin = c->margin_to_first_deg;
  return moves && above && c->has_margin_to_first && margin.value + margin.error < 0;
}

static void govern(tp_case *c, const tp_solution *solution) {
  tp_governing_fos *g = &c->governing_fos;
  *g = (tp_governing_fos){.fos = {.state = TP_FOS_NO_TILT},
                          .sliding_judged = solution->has_friction,
                          .complete = solution->has_friction};
  if (!solution->has_tilt_angle) return;
  g->fos.state = TP_FOS_NOT_ASKED;
  const tp_contact_result *contact = &solution->contact;
  if (contact->facets > 0 ||
      contact->points > contact->corner_points) { /* else nothing carries it */
    add_moments(g, c);
    add_sliding(g, c, solution->loaded);
  }
  if (c->limit.kind != TP_LIMIT_NOT_ASKED) add_reduction(g, &c->limit);
  if (c->limit.fos.state == TP_FOS_NOT_ASKED || c->limit.kind == TP_LIMIT_NOT_ASKED) {
    g->complete = false;
  }
  g->up_dip = c->falls_backwards;
  if (g->up_dip) {
    g->fos.state = TP_FOS_UNDEFINED;
    return;
  }
  take_least(g);
  g->beyond = lets_go_before(c);
  if (!g->beyond) return;
  g->fos.state = TP_FOS_UNDEFINED;
  g->has_factor = false;
}

void tp_solution_govern(tp_solution *solution) {
  for (size_t k = 0; k < solution->case_count; k++) govern(solution->cases + k, solution);
}

/* Of a factor alone, whatever the mechanism. */
static tp_design meets(const tp_governing_fos *g, double design_fos) {
  if (!g->sliding_judged) return TP_DESIGN_NOT_MET;
  switch (rank_of(g->fos)) {
  case RANK_NONE:
  case RANK_ABSENT:
    return TP_DESIGN_NOT_MET;
  case RANK_UNDECIDED:
    return TP_DESIGN_OPEN;
  case RANK_UNBOUNDED:
    return g->complete ? TP_DESIGN_MET : TP_DESIGN_OPEN;
  case RANK_NUMBER:
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
