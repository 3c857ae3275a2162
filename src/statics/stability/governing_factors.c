/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The two factors of the onset count as they are. A formula of the field counts where it is one of
 * them: then its mechanism is the one that begins. Any other formula is of a motion that contact
 * forces prevent, or that comes after another one. */

#include "stability/governing_factors.h"

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

/* What moves the block at the tilt: that of the verdict, or of what may move the first. */
static tp_mechanism mover(const tp_case *c) {
  return c->mechanism == TP_MAY_MOVE && c->onset.beginning_count > 0 ? c->onset.beginnings[0]
                                                                     : c->mechanism;
}

/* How a block that moves can begin to: by a mechanism, if it is among those that can begin, or else
 * by the one that is named. */
static tp_mechanism beginning(const tp_at_scene *at, tp_mechanism mechanism) {
  const tp_onset *onset = &at->c->onset;
  for (size_t k = 0; at->moves && k < onset->beginning_count; k++) {
    if (onset->beginnings[k] == mechanism) return mechanism;
  }
  return at->moves ? mover(at->c) : mechanism;
}

/* Are two factors one number? Both are proven to more digits than are asked for. */
static bool agree(tp_fos one, tp_fos other) {
  static const double spare = 1e-9;
  const tp_fos_rank rank = tp_fos_rank_of(one);
  if (rank != tp_fos_rank_of(other)) return false;
  if (rank != TP_RANK_NUMBER) return rank == TP_RANK_UNBOUNDED;
  return fabs(one.value.value - other.value.value) <=
         one.value.error + other.value.error + spare * fabs(other.value.value);
}

static bool is_known(tp_fos fos) {
  const tp_fos_rank rank = tp_fos_rank_of(fos);
  return rank != TP_RANK_UNDECIDED && rank != TP_RANK_ABSENT;
}

/* Whether a formula is one of the factors of the onset; while none of these is known it counts. */
static tp_factor_standing standing(const tp_at_scene *at, tp_fos fos) {
  const tp_onset *onset = &at->c->onset;
  if (onset->kind == TP_ONSET_NOT_ASKED || !(is_known(onset->fos) || is_known(onset->fos_driving)))
    return TP_FACTOR_COUNTS;
  return agree(fos, onset->fos_driving) || agree(fos, onset->fos) ? TP_FACTOR_COUNTS
                                                                  : TP_FACTOR_PREVENTED;
}

/* ---- formulas ----------------------------------------------------------------------------------
 */

static tp_factor by_moments(const tp_at_scene *at, const tp_pivot *p) {
  const tp_case *c = at->c;
  const size_t toe = c->towards == TP_TOWARDS_LEFT ? 0 : c->candidate_count - 1;
  tp_factor factor = {.definition = TP_FOS_BY_MOMENTS,
                      .mechanism = beginning(at, TP_TOPPLES),
                      .pivot = p->index,
                      .toe = p->index == toe,
                      .fos = p->fos,
                      .standing = standing(at, p->fos)};
  if (factor.standing != TP_FACTOR_COUNTS) factor.mechanism = TP_TOPPLES;
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
    const tp_factor f = by_moments(at, c->pivots + k);
    if (has[f.counts] && !tp_fos_is_less(f.fos, least[f.counts].fos)) continue;
    least[f.counts] = f;
    has[f.counts] = true;
  }
  if (has[false] && !(has[true] && tp_fos_is_less(least[true].fos, least[false].fos)))
    add(g, least[false]);
  if (has[true]) add(g, least[true]);
}

static void add_sliding(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_sliding *s = &at->c->sliding;
  const bool loaded = at->solution->loaded;
  if (!s->known) return;
  const bool smooth = s->friction_angle_deg.value == 0 && s->friction_angle_deg.error == 0;
  tp_factor factor = {.definition = TP_FOS_BY_SHEAR,
                      .mechanism = TP_SLIDES,
                      .fos = loaded ? s->fos : s->fos_strength};
  for (int k = 0; k < 2; k++) {
    factor.standing = !s->opens   ? TP_FACTOR_BLOCKED
                      : s->uneven ? TP_FACTOR_UNEVEN
                                  : standing(at, factor.fos);
    const bool zero = factor.fos.state == TP_FOS_NUMBER && factor.fos.value.value == 0;
    if (smooth && zero && factor.standing == TP_FACTOR_COUNTS) factor.standing = TP_FACTOR_SMOOTH;
    factor.counts = factor.standing == TP_FACTOR_COUNTS;
    factor.mechanism = factor.counts ? beginning(at, TP_SLIDES) : TP_SLIDES;
    add(g, factor);
    const tp_bounded i = s->facet_angle_deg;
    if (loaded || (i.value == 0 && i.error == 0)) return; /* the same */
    factor.definition = TP_FOS_BY_ROUGHNESS;
    factor.fos = s->fos;
  }
}

/* ---- factors of the onset ----------------------------------------------------------------------
 */

static void add_driving(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_onset *onset = &at->c->onset;
  add(g, (tp_factor){.definition = TP_FOS_BY_DRIVING,
                     .mechanism = at->moves ? mover(at->c) : onset->fos_driving_mechanism,
                     .counts = true,
                     .fos = onset->fos_driving});
}

/* The window of motion that holds the tilt, or else the next one above it; NULL: none. */
static const tp_window *window_at(const tp_at_scene *at) {
  const tp_onset *onset = &at->c->onset;
  const double tilt = at->solution->tilt_angle_deg.value;
  for (size_t k = 0; k < onset->window_count; k++) {
    const tp_window *w = onset->windows + k;
    if (w->to_above || w->to_deg.value + w->to_deg.error >= tilt) return w;
  }
  return NULL;
}

/* Does a change of strength decide when the motion of a block that moves begins? Where friction
 * depends on the stress the windows are those of another one, and it is taken so. */
static bool strength_decides(const tp_at_scene *at) {
  if (!at->moves || at->solution->friction_is_residual) return true;
  const tp_window *w = window_at(at);
  return w == NULL || w->from_below || w->from_by_strength;
}

static void add_reduction(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_onset *onset = &at->c->onset;
  tp_factor factor = {.definition = TP_FOS_BY_REDUCTION,
                      .mechanism = at->moves ? mover(at->c) : onset->fos_mechanism,
                      .fos = onset->fos};
  factor.raised = onset->fos.state == TP_FOS_NUMBER && onset->fos_raised != at->moves;
  const bool driving = tp_fos_rank_of(onset->fos_driving) == TP_RANK_NUMBER;
  const bool stops = tp_fos_rank_of(onset->fos) == TP_RANK_NUMBER && !factor.raised;
  const bool unaffected = at->moves && driving && !(stops && strength_decides(at));
  factor.standing = unaffected ? TP_FACTOR_UNAFFECTED : TP_FACTOR_COUNTS;
  factor.counts = !unaffected;
  add(g, factor);
}

void tp_governing_add_factors(tp_governing_fos *g, const tp_at_scene *at) {
  const tp_contact_result *contact = &at->solution->contact;
  if (contact->facets > 0 || contact->points > contact->corner_points) { /* else nothing carries */
    add_moments(g, at);
    add_sliding(g, at);
  }
  if (at->c->onset.kind == TP_ONSET_NOT_ASKED) return;
  add_driving(g, at);
  add_reduction(g, at);
}

bool tp_governing_tilt(tp_bounded *degrees, const tp_at_scene *at) {
  const tp_window *w = window_at(at);
  if (at->solution->loaded || at->solution->friction_is_residual || w == NULL || w->from_below ||
      tp_fos_rank_of(at->c->onset.fos_driving) != TP_RANK_NUMBER) {
    return false;
  }
  *degrees = w->from_deg;
  return true;
}
