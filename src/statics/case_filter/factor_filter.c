/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The governing factor in doubles with bounds: the lesser of those on driving loads and by
 * strength, by the rule of verdict/safety.h, and which formula of the field it is, as
 * stability/governing_factors.c has it. Any comparison that stays open leaves the sample to the
 * full solve. */

#include "case_filter/factor_filter.h"

#include "case_filter/driving_filter.h"
#include "case_filter/moments_filter.h"
#include "case_filter/sliding_filter.h"
#include "case_filter/strength_filter.h"
#include "verdict/safety.h"

/* What is known at the tilt. */
typedef struct factors {
  const tp_case_told *told;
  const tp_filter_state *state;
  tp_driving_told driving;
  bool has_strength; /* it counts and may be the lesser of both: */
  tp_near strength;
  tp_mechanism strength_mechanism;
  tp_fos_told governs; /* the lesser of both */
  bool named;          /* which formula, or factor, it is: */
  tp_fos_definition definition;
  tp_mechanism mechanism;
} factors;

/* ---- the factors of the onset ------------------------------------------------------------------
 */

/* The factor by strength, of a block that stands only if it is not above that on driving loads; of
 * one that moves only if strength decides when the motion begins. */
static bool find_strength(factors *f) {
  const tp_case_told *told = f->told;
  const tp_filter_state *s = f->state;
  const bool number = f->driving.fos.state == TP_FOS_NUMBER;
  const tp_near driving = f->driving.fos.value;
  const double most =
      number && !s->moves ? (driving.value + driving.error) * (1 + 0x1p-30) : INFINITY;
  tp_strength_told own;
  if (!tp_strength_filter_find(&own, &told->of, s->tangent, s->moves, most)) return false;
  if (own.farther) return true;
  if (!own.found) return !s->moves || number;
  const bool raised = own.share.value > 1;
  if (s->moves && !(raised && tp_strength_filter_moves_onset(&told->of, told->onset.tangent))) {
    return true;
  }
  f->has_strength = true;
  f->strength = raised == s->moves ? tp_near_div((tp_near){1, 0}, own.share) : own.share;
  f->strength_mechanism = s->moves ? s->mover : own.mechanism;
  return true;
}

static tp_factor_range range_of(tp_fos_definition definition, tp_mechanism mechanism,
                                tp_fos_state state, tp_near value) {
  const tp_fos fos = {state, {.value = value.value, .error = value.error}};
  return tp_factor_range_of(definition, mechanism, fos);
}

/* The lesser of both. */
static bool govern(factors *f) {
  tp_factor_range ranges[2];
  size_t count = 0;
  const tp_fos_told *d = &f->driving.fos;
  ranges[count++] = range_of(TP_FOS_BY_DRIVING, f->driving.mechanism, d->state, d->value);
  if (f->has_strength) {
    ranges[count++] =
        range_of(TP_FOS_BY_REDUCTION, f->strength_mechanism, TP_FOS_NUMBER, f->strength);
  }
  const tp_safety safety =
      tp_safety_of(f->state->moves ? TP_VERDICT_CAN_MOVE : TP_VERDICT_STANDS, ranges, count);
  const tp_fos fos = tp_safety_fos(&safety);
  f->governs = (tp_fos_told){fos.state, tp_near_of(fos.value.value, fos.value.error)};
  return fos.state == TP_FOS_NUMBER || fos.state == TP_FOS_NO_OVERTURNING;
}

/* ---- what it is called -------------------------------------------------------------------------
 */

/* Are two factors one number, to a thousand millionth? 1, -1: no, 0: open. */
static int agree(tp_fos_told a, tp_fos_told b) {
  static const double spare = 1e-9;
  if (a.state != b.state) return -1;
  if (a.state != TP_FOS_NUMBER) return 1;
  const tp_near apart = tp_near_sub(a.value, b.value);
  const double most = a.value.error + b.value.error + spare * fabs(b.value.value);
  return fabs(apart.value) <= most / 2 ? 1 : fabs(apart.value) > 2 * most ? -1 : 0;
}

static void name(factors *f, tp_fos_definition definition, tp_mechanism mechanism) {
  if (f->named) return;
  f->named = true;
  f->definition = definition;
  f->mechanism = mechanism;
}

/* How a block that moves can begin to: by a mechanism, if it is among those that can begin, or else
 * by the one that is named. */
static tp_mechanism beginning(const tp_filter_state *s, tp_mechanism mechanism) {
  return !s->moves || (s->beginnings & 1U << mechanism) != 0 ? mechanism : s->mover;
}

/* A formula is that of the governing factor, or of the greater one, or of neither. */
static bool judge(bool *counts, factors *f, const tp_filter_way *way) {
  const tp_fos_told strength = {TP_FOS_NUMBER, f->strength};
  const int same = agree(way->fos, f->governs);
  const int driving = agree(way->fos, f->driving.fos);
  const int by_strength = f->has_strength ? agree(way->fos, strength) : -1;
  *counts = driving > 0 || by_strength > 0;
  if (same > 0) name(f, way->definition, way->mechanism);
  return same != 0 && driving != 0 && by_strength != 0;
}

static tp_fos_told lesser(tp_fos_told a, tp_fos_told b) {
  if (a.state != TP_FOS_NUMBER) return b;
  if (b.state == TP_FOS_NUMBER) a.value = tp_near_lesser(a.value, b.value);
  return a;
}

/* About the pivot that governs, and then all others that are admissible; `by_moments` is the least
 * of those that count, or else of all. */
static bool take_moments(tp_fos_told *by_moments, factors *f) {
  const tp_case_told *told = f->told;
  tp_fos_told found[2]; /* by whether they count */
  bool has[2] = {false, false};
  for (int k = -1; k < told->filter->pivot_count; k++) {
    const tp_filter_pivot *pivot = k < 0 ? told->pivot : told->filter->pivots + k;
    if (k >= 0 && (!pivot->admissible || pivot == told->pivot)) continue;
    tp_filter_way way;
    bool counts = false;
    if (!tp_moments_filter(&way, told, f->state, pivot)) return false;
    way.mechanism = beginning(f->state, TP_TOPPLES);
    if (!judge(&counts, f, &way)) return false;
    found[counts] = has[counts] ? lesser(found[counts], way.fos) : way.fos;
    has[counts] = true;
  }
  *by_moments = found[has[true]];
  return true;
}

static bool take_sliding(tp_fos_told *by_shear, factors *f) {
  tp_sliding_told sliding;
  bool counts = false;
  if (!tp_sliding_filter(&sliding, f->told, f->state->tangent)) return false;
  *by_shear = (tp_fos_told){sliding.shear, sliding.by_shear};
  if (!sliding.counts) return true;
  tp_filter_way way = {
      .fos = *by_shear, .definition = TP_FOS_BY_SHEAR, .mechanism = beginning(f->state, TP_SLIDES)};
  if (!judge(&counts, f, &way)) return false;
  if (sliding.is_level) return true;
  way.fos = (tp_fos_told){sliding.rough, sliding.by_roughness};
  way.definition = TP_FOS_BY_ROUGHNESS;
  return judge(&counts, f, &way);
}

/* The factors themselves, behind the formulas. */
static bool take_factors(factors *f) {
  const tp_fos_told strength = {TP_FOS_NUMBER, f->strength};
  const int driving = agree(f->driving.fos, f->governs);
  const int by_strength = f->has_strength ? agree(strength, f->governs) : -1;
  if (f->named) return true;
  if (driving == 0 || by_strength == 0) return false;
  if (driving > 0) {
    const bool known = f->state->moves || f->driving.has_mechanism ||
                       f->driving.fos.state == TP_FOS_NO_OVERTURNING;
    name(f, TP_FOS_BY_DRIVING, f->state->moves ? f->state->mover : f->driving.mechanism);
    return known;
  }
  name(f, TP_FOS_BY_REDUCTION, f->strength_mechanism);
  return by_strength > 0;
}

bool tp_factor_filter(tp_case_told_at *at, const tp_case_told *told, const tp_filter_state *s) {
  factors f = {.told = told, .state = s};
  if (!tp_driving_filter(&f.driving, told, s) || !find_strength(&f) || !govern(&f) ||
      !take_moments(&at->by_moments, &f) || !take_sliding(&at->by_shear, &f) || !take_factors(&f)) {
    return false;
  }
  at->fos = f.governs;
  at->fos_mechanism = f.mechanism;
  at->fos_definition = f.definition;
  return true;
}
