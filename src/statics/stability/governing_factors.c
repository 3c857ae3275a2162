/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A factor below 1 counts only where its motion is among those that can begin at the tilt, and one
 * above 1 only where a motion can begin at the tilt at which it comes to 1: else contact forces
 * prevent it. */

#include "stability/governing_factors.h"

#include "number/near_angle.h"

#include <math.h>

tp_fos_rank tp_fos_rank_of(tp_fos fos) {
  switch (fos.state) {
  case TP_FOS_NUMBER:
    return fos.value.value < -fos.value.error ? TP_RANK_NONE : TP_RANK_NUMBER;
  case TP_FOS_UNDEFINED:
    return TP_RANK_NONE;
  case TP_FOS_UNDECIDED:
    return TP_RANK_UNDECIDED;
  case TP_FOS_NO_OVERTURNING:
    return TP_RANK_UNBOUNDED;
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
  return TP_RANK_ABSENT;
}

bool tp_fos_is_less(tp_fos one, tp_fos other) {
  const tp_fos_rank own = tp_fos_rank_of(one), held = tp_fos_rank_of(other);
  if (own != held) return own < held;
  return own == TP_RANK_NUMBER && one.value.value < other.value.value;
}

static void add(tp_governing_fos *g, tp_factor factor) {
  if (tp_fos_rank_of(factor.fos) != TP_RANK_ABSENT) g->factors[g->factor_count++] = factor;
}

/* ---- which count -------------------------------------------------------------------------------
 */

bool tp_fos_is_below(tp_fos fos) {
  const tp_fos_rank own = tp_fos_rank_of(fos);
  return own == TP_RANK_NONE || (own == TP_RANK_NUMBER && fos.value.value + fos.value.error < 1);
}

bool tp_fos_is_above(tp_fos fos) {
  const tp_fos_rank own = tp_fos_rank_of(fos);
  return own == TP_RANK_UNBOUNDED ||
         (own == TP_RANK_NUMBER && fos.value.value - fos.value.error > 1);
}

tp_at_scene tp_at_scene_of(const tp_case *c, const tp_solution *solution) {
  tp_at_scene at = {.c = c, .solution = solution};
  if (c->onset.kind == TP_ONSET_NOT_ASKED) return at;
  at.stands = c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED;
  at.moves = !at.stands && c->mechanism != TP_MECHANISM_UNDECIDED;
  return at;
}

static bool can_begin(const tp_onset *onset, tp_mechanism mechanism) {
  for (size_t k = 0; k < onset->beginning_count; k++) {
    if (onset->beginnings[k] == mechanism) return true;
  }
  return false;
}

/* What moves the block at the tilt: that of the verdict, or of what may move the first. */
static tp_mechanism mover(const tp_case *c) {
  return c->mechanism == TP_MAY_MOVE && c->onset.beginning_count > 0 ? c->onset.beginnings[0]
                                                                     : c->mechanism;
}

/* How it turns about the pivot, if it can: sticking there, or else slipping there alone. */
static tp_mechanism turn_about(const tp_onset *onset, size_t pivot) {
  tp_mechanism found = TP_MECHANISM_UNDECIDED;
  for (size_t k = 0; k < onset->motion_count && found != TP_TOPPLES; k++) {
    const tp_motion *m = onset->motions + k;
    bool sticks = false, alone = m->mechanism != TP_SLIDES && m->contact_count > 0;
    for (size_t j = 0; j < m->contact_count; j++) {
      const tp_motion_contact *own = m->contacts + j;
      const bool here = own->has_pivot && own->pivot == pivot;
      sticks = sticks || (here && own->state == TP_CONTACT_STICKS);
      alone = alone && here;
    }
    if (alone || (sticks && m->mechanism == TP_TOPPLES)) found = m->mechanism;
  }
  return found;
}

/* The window that holds one of two tilts in degrees and all between them, or NULL. */
static const tp_window *window_of(const tp_onset *onset, double low, double high) {
  for (size_t k = 0; k < onset->window_count; k++) {
    const tp_window *w = onset->windows + k;
    const bool above = w->from_below || w->from_deg.value - w->from_deg.error <= low;
    const bool below = w->to_above || w->to_deg.value + w->to_deg.error >= high;
    if (above && below) return w;
  }
  return NULL;
}

/* Can motions begin at the tilt at which a factor is 1, and, of a block that moves, from there to
 * its own? Where friction depends on the stress, the windows are not those of another tilt, and it
 * is taken so. */
static bool begins_at(const tp_at_scene *at, tp_bounded degrees) {
  static const double beside = 1e-9, upright = 90;
  const double tilt = at->solution->tilt_angle_deg.value;
  const double least = degrees.value - degrees.error - beside;
  const double most = degrees.value + degrees.error + beside;
  const tp_onset *onset = &at->c->onset;
  if (at->solution->friction_is_residual || onset->kind == TP_ONSET_UNDECIDED) return true;
  if (at->moves) return window_of(onset, fmin(most, tilt), fmax(least, tilt)) != NULL;
  return most >= upright || most <= tilt || window_of(onset, most, least) != NULL;
}

/* By where its factor is 1, and whether the motion it is about can begin at the tilt. */
static tp_factor_standing standing(const tp_at_scene *at, tp_fos fos, bool has_angle,
                                   tp_bounded degrees, bool begins) {
  const bool told = at->stands || (at->moves && at->c->onset.has_motions);
  const bool below = tp_fos_is_below(fos);
  if (!told || (!below && !(at->stands && tp_fos_is_above(fos)))) return TP_FACTOR_COUNTS;
  if (below && !begins) return TP_FACTOR_PREVENTED;
  return has_angle && !begins_at(at, degrees) ? TP_FACTOR_PREVENTED : TP_FACTOR_COUNTS;
}

static tp_factor by_moments(const tp_at_scene *at, const tp_pivot *p) {
  const tp_case *c = at->c;
  const size_t toe = c->towards == TP_TOWARDS_LEFT ? 0 : c->candidate_count - 1;
  const tp_mechanism turn = turn_about(&c->onset, p->index);
  tp_factor factor = {.definition = TP_FOS_BY_MOMENTS,
                      .mechanism = TP_TOPPLES,
                      .pivot = p->index,
                      .toe = p->index == toe,
                      .fos = p->fos};
  const bool begins = at->moves && turn != TP_MECHANISM_UNDECIDED;
  if (begins) factor.mechanism = turn;
  factor.standing =
      standing(at, factor.fos, !p->never && !p->always, p->critical_angle_deg, begins);
  factor.counts = factor.standing == TP_FACTOR_COUNTS;
  return factor;
}

/* About the admissible pivot that is the least safe of those that count; and before it, where that
 * is less safe, of those that do not. Of pivots alike the one that governs. */
static void add_moments(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_case *c = at->c;
  if (!c->has_toppling_pivot) return;
  tp_factor least[2]; /* by whether they count */
  bool has[2] = {false, false};
  for (size_t step = 0; step <= c->pivot_count; step++) {
    const size_t k = step == 0 ? c->toppling_pivot : step - 1;
    if (step > 0 && (!c->pivots[k].admissible || k == c->toppling_pivot)) continue;
    const tp_factor own = by_moments(at, c->pivots + k);
    if (has[own.counts] && !tp_fos_is_less(own.fos, least[own.counts].fos)) continue;
    least[own.counts] = own;
    has[own.counts] = true;
  }
  if (has[false] && !(has[true] && tp_fos_is_less(least[true].fos, least[false].fos)))
    add(g, least[false]);
  if (has[true]) add(g, least[true]);
}

/* Can it slip along its facet? Where a bond alone keeps it from sliding, while it turns as well. */
static bool slip_begins(const tp_case *c, tp_mechanism *mechanism) {
  const tp_onset *onset = &c->onset;
  if (can_begin(onset, TP_SLIDES)) return true;
  if (!c->slides_sooner) return false;
  if (!can_begin(onset, TP_SLIDES_AND_TOPPLES)) return onset->beginning_count == 0;
  *mechanism = TP_SLIDES_AND_TOPPLES;
  return true;
}

static void add_sliding(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_case *c = at->c;
  const tp_sliding *s = &c->sliding;
  const bool loaded = at->solution->loaded;
  if (!s->known) return;
  tp_mechanism mechanism = TP_SLIDES;
  const bool begins = at->moves && slip_begins(c, &mechanism);
  const bool smooth = s->friction_angle_deg.value == 0 && s->friction_angle_deg.error == 0;
  tp_factor factor = {.definition = TP_FOS_BY_SHEAR,
                      .mechanism = mechanism,
                      .fos = loaded ? s->fos : s->fos_strength};
  for (int k = 0; k < 2; k++) {
    factor.standing = !s->opens ? TP_FACTOR_BLOCKED
                      : s->uneven
                          ? TP_FACTOR_UNEVEN
                          : standing(at, factor.fos, !s->never && !s->always && !c->slides_sooner,
                                     s->critical_angle_deg, begins);
    const bool zero = factor.fos.state == TP_FOS_NUMBER && factor.fos.value.value == 0;
    if (smooth && zero && factor.standing == TP_FACTOR_COUNTS) factor.standing = TP_FACTOR_SMOOTH;
    factor.counts = factor.standing == TP_FACTOR_COUNTS;
    add(g, factor);
    const tp_bounded i = s->facet_angle_deg;
    if (loaded || (i.value == 0 && i.error == 0)) return; /* the same */
    factor.definition = TP_FOS_BY_ROUGHNESS;
    factor.fos = s->fos;
  }
}

static void add_reduction(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_onset *onset = &at->c->onset;
  add(g, (tp_factor){.definition = TP_FOS_BY_REDUCTION,
                     .mechanism = at->moves ? mover(at->c) : onset->fos_mechanism,
                     .counts = true,
                     .raised = onset->fos.state == TP_FOS_NUMBER && onset->fos_raised != at->moves,
                     .fos = onset->fos});
}

/* tan(one) / tan(other) of tilts above 0 and below 90 degrees. */
static tp_bounded tangents(tp_bounded one, tp_bounded other) {
  tp_near sine, cosine, other_sine, other_cosine;
  tp_near_sin_cos(&sine, &cosine, (tp_near){one.value, one.error});
  tp_near_sin_cos(&other_sine, &other_cosine, (tp_near){other.value, other.error});
  const tp_near ratio =
      tp_near_div(tp_near_mul(sine, other_cosine), tp_near_mul(cosine, other_sine));
  return (tp_bounded){.value = ratio.value, .error = ratio.error};
}

/* What is known of a factor by the tilt. */
typedef struct by_tilt {
  const tp_at_scene *at;
  bool has;           /* of several ends that whose ratio is nearest to 1 counts, */
  tp_bounded end_deg; /* this one */
  tp_factor factor;
} by_tilt;

/* An end of a window above or below the tilt; motions begin there, or end. */
static void add_end(by_tilt *own, const tp_window *w, tp_bounded end) {
  const tp_bounded tilt = own->at->solution->tilt_angle_deg;
  const double upright = 90;
  if (!(end.value - end.error > 0 && end.value + end.error < upright)) return;
  const bool above = (end.value > tilt.value) != own->at->moves;
  const tp_bounded ratio = above ? tangents(end, tilt) : tangents(tilt, end);
  const double held = own->factor.fos.value.value;
  if (!isfinite(ratio.error)) return;
  if (own->has && fabs(log(ratio.value)) >= fabs(log(held))) return;
  own->has = true;
  own->end_deg = end;
  own->factor.fos = (tp_fos){TP_FOS_NUMBER, ratio};
  own->factor.mechanism = own->at->moves ? mover(own->at->c) : w->begins;
}

/* Does one count that is not above 1, of a way that can begin? */
static bool has_way(const tp_governing_fos *g) {
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *own = g->factors + k;
    const bool way = own->definition < TP_FOS_BY_REDUCTION;
    if (way && own->counts && !tp_fos_is_above(own->fos)) return true;
  }
  return false;
}

static bool is_at(tp_bounded degrees, tp_bounded end) {
  static const double beside = 1e-9;
  return fabs(degrees.value - end.value) <= degrees.error + end.error + beside;
}

/* Is a factor that counts 1 at an end of a window: by moments, or along the facet? */
static bool formulas_tell(const tp_governing_fos *g, const tp_at_scene *at, tp_bounded end) {
  const tp_case *c = at->c;
  const tp_sliding *s = &c->sliding;
  for (size_t k = 0; k < g->factor_count; k++) {
    const bool shear = g->factors[k].definition == TP_FOS_BY_SHEAR && g->factors[k].counts;
    if (shear && !s->never && !s->always && is_at(s->critical_angle_deg, end)) return true;
  }
  for (size_t k = 0; k < c->pivot_count && c->has_toppling_pivot; k++) {
    const tp_pivot *p = c->pivots + k;
    if (!p->admissible || p->never || p->always || !is_at(p->critical_angle_deg, end)) continue;
    if (by_moments(at, p).counts) return true;
  }
  return false;
}

/* Where no change of strength matters, the tilt tells, and of an end of a window at which no other
 * factor is 1; and where motions end as it rises, how far it lies above that. */
static bool add_tilt(tp_governing_fos *g, const tp_at_scene *at, tp_bounded *end_deg) {
  const tp_onset *onset = &at->c->onset;
  const tp_bounded tilt = at->solution->tilt_angle_deg;
  const double upright = 90;
  by_tilt own = {.at = at, .factor = {.definition = TP_FOS_BY_TILT, .counts = true}};
  const bool sits = tilt.value > 0 && tilt.value < upright && (at->moves || at->stands);
  if (!sits || at->solution->friction_is_residual) return false;
  const bool strength = onset->fos.state == TP_FOS_NUMBER;
  const bool told = strength || (at->moves && has_way(g));
  for (size_t k = 0; k < onset->window_count; k++) {
    const tp_window *w = onset->windows + k;
    const bool holds = window_of(onset, tilt.value, tilt.value) == w;
    if (at->moves != holds) continue;
    const bool rises = w->from_deg.value > tilt.value;
    const bool from = !told || !(w->from_by_strength || formulas_tell(g, at, w->from_deg));
    const bool to = !told || !(w->to_by_strength || formulas_tell(g, at, w->to_deg));
    if (!w->from_below && (at->moves || rises) && from) add_end(&own, w, w->from_deg);
    if (!w->to_above && (at->moves ? to : !rises)) add_end(&own, w, w->to_deg);
  }
  if (own.has) add(g, own.factor);
  if (own.has) *end_deg = own.end_deg;
  return own.has;
}

void tp_governing_add_formulas(tp_governing_fos *g, const tp_at_scene *at) {
  add_moments(g, at);
  add_sliding(g, at);
}

bool tp_governing_add_onset(tp_governing_fos *g, const tp_at_scene *at, tp_bounded *end_deg) {
  add_reduction(g, at);
  return add_tilt(g, at, end_deg);
}
