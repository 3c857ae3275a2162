/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Governing factor in doubles with bounds: moments about each admissible pivot, sliding and
 * strength, the least of those that count; any undecided comparison leaves the sample to the full
 * solve. */

#include "case_filter/factor_filter.h"

#include "case_filter/moments_filter.h"
#include "case_filter/sliding_filter.h"
#include "case_filter/strength_filter.h"

/* ---- what governs ------------------------------------------------------------------------------
 */

/* What governs so far. */
typedef struct least {
  bool any, number;
  bool at_onset, perhaps_at_onset; /* one that counts is 1 there */
  tp_near fos;
  tp_mechanism mechanism;
  tp_fos_definition definition;
} least;

static void name(least *l, tp_fos_definition definition, tp_mechanism mechanism) {
  l->definition = definition;
  l->mechanism = mechanism;
}

/* A factor against a mechanism, a number or beyond all. Of numbers that are not told apart the
 * first is named; their mechanisms have to be the same. */
static bool take(least *l, tp_fos_state state, tp_near fos, tp_fos_definition definition,
                 tp_mechanism mechanism) {
  if (state != TP_FOS_NUMBER) {
    if (!l->any) name(l, definition, mechanism);
    l->any = true;
    return true;
  }
  if (tp_near_sign(fos) <= 0) return false;
  const int order = l->number ? tp_near_sign(tp_near_sub(fos, l->fos)) : -1;
  if (order == 0 && mechanism != l->mechanism) return false;
  if (order < 0) name(l, definition, mechanism);
  if (order < 0) l->fos = fos;
  if (order == 0) l->fos = tp_near_lesser(l->fos, fos);
  l->any = l->number = true;
  return true;
}

/* A factor that counts is 1 at the onset where the two tilts are one to 1e-9 degrees
 * (stability/governing_factors.c); what is near that is open. */
static void note_onset(least *l, const tp_case_told *told, const tp_filter_way *own) {
  static const double beside_deg = 1e-9;
  if (told->never || !own->has_critical) return;
  const tp_near onset = told->onset.tangent, apart = tp_near_sub(own->critical, onset);
  const double beside = beside_deg * M_PI / 180 * (1 + onset.value * onset.value);
  const double size = fabs(apart.value);
  if (size - apart.error > 2 * beside) return;
  l->at_onset = l->at_onset || size + apart.error < beside / 2;
  l->perhaps_at_onset = true;
}

/* What counts; of a block that moves, what is below 1 alone. */
static bool take_counting(least *l, const tp_case_told *told, const tp_filter_state *s,
                          const tp_filter_way *own) {
  static const tp_near one = {1, 0};
  const tp_fos_told *fos = &own->fos;
  note_onset(l, told, own);
  const bool below = fos->state == TP_FOS_NUMBER && tp_near_sign(tp_near_sub(fos->value, one)) < 0;
  return (s->moves && !below) || take(l, fos->state, fos->value, own->definition, own->mechanism);
}

static bool take_judged(least *l, const tp_case_told *told, const tp_filter_state *s,
                        const tp_filter_way *own) {
  const tp_filter_standing standing = tp_standing_filter(told, s, own);
  return standing == TP_FILTER_EXCLUDED ||
         (standing == TP_FILTER_COUNTS && take_counting(l, told, s, own));
}

/* The less safe of two. */
static tp_fos_told lesser(tp_fos_told a, tp_fos_told b) {
  if (a.state != TP_FOS_NUMBER) return b;
  if (b.state == TP_FOS_NUMBER) a.value = tp_near_lesser(a.value, b.value);
  return a;
}

/* About the pivot that governs, and then all others that are admissible; `by_moments` is the least
 * of those that count, or else of all. */
static bool take_moments(least *l, tp_fos_told *by_moments, const tp_case_told *told,
                         const tp_filter_state *s) {
  tp_fos_told found[2]; /* by whether they count */
  bool has[2] = {false, false};
  for (int k = -1; k < told->filter->pivot_count; k++) {
    const tp_filter_pivot *pivot = k < 0 ? told->pivot : told->filter->pivots + k;
    if (k >= 0 && (!pivot->admissible || pivot == told->pivot)) continue;
    tp_filter_way own;
    if (!tp_moments_filter(&own, told, s, pivot)) return false;
    const tp_filter_standing standing = tp_standing_filter(told, s, &own);
    const bool counts = standing == TP_FILTER_COUNTS;
    if (standing == TP_FILTER_OPEN || (counts && !take_counting(l, told, s, &own))) return false;
    found[counts] = has[counts] ? lesser(found[counts], own.fos) : own.fos;
    has[counts] = true;
  }
  *by_moments = found[has[true]];
  return true;
}

static bool take_sliding(least *l, tp_fos_told *by_shear, const tp_case_told *told,
                         const tp_filter_state *s) {
  tp_sliding_told sliding;
  if (!tp_sliding_filter(&sliding, told, s->tangent)) return false;
  *by_shear = (tp_fos_told){sliding.shear, sliding.by_shear};
  if (!sliding.counts) return true;
  tp_filter_way own = {.fos = *by_shear,
                       .has_critical = sliding.has_critical,
                       .critical = sliding.critical,
                       .begins = s->moves && (s->beginnings & 1U << TP_SLIDES) != 0,
                       .definition = TP_FOS_BY_SHEAR,
                       .mechanism = TP_SLIDES};
  if (!take_judged(l, told, s, &own)) return false;
  if (sliding.is_level) return true;
  own.fos = (tp_fos_told){sliding.rough, sliding.by_roughness};
  own.definition = TP_FOS_BY_ROUGHNESS;
  return take_judged(l, told, s, &own);
}

/* What begins at the onset, where that is one mechanism alone. */
static bool find_beginning(tp_mechanism *mechanism, const tp_case_told *told) {
  static const double beside = 0x1p-30;
  const tp_near at = tp_near_mul(told->onset.tangent, (tp_near){1 + beside, 0});
  bool moves = false;
  unsigned beginnings = 0;
  if (!tp_onset_filter_look(&moves, &beginnings, &told->onset, at) || beginnings == 0) return false;
  int first = TP_SLIDES;
  while ((beginnings & 1U << first) == 0) first++;
  *mechanism = (tp_mechanism)first;
  return beginnings == 1U << first;
}

/* Of the factor by the tilt less what governs: the sign, 0 where doubles do not tell the two apart.
 */
static int order_of_tilt(const least *l, const tp_case_told *told, const tp_filter_state *s) {
  if (told->never || tp_near_is_zero(s->tangent)) return 1;
  const tp_near fos = tp_near_div(told->onset.tangent, s->tangent);
  return l->number ? tp_near_sign(tp_near_sub(fos, l->fos)) : -1;
}

/* Of a block that stands whatever its strength: by the tilt, if that is less than what governs by
 * then. */
static bool take_tilt(least *l, const tp_case_told *told, const tp_filter_state *s) {
  const int order = order_of_tilt(l, told, s);
  if (order > 0) return true;
  const tp_near fos = tp_near_div(told->onset.tangent, s->tangent);
  if (order == 0) l->fos = tp_near_lesser(l->fos, fos);
  if (order == 0) return true;
  tp_mechanism mechanism = TP_MECHANISM_UNDECIDED;
  return find_beginning(&mechanism, told) && take(l, TP_FOS_NUMBER, fos, TP_FOS_BY_TILT, mechanism);
}

/* Do the modes that hold the tilt lead on to a wanted one? */
static bool reaches(const tp_onset_filter *o, tp_near tangent, tp_near wanted) {
  static const double beside = 0x1p-30;
  tp_near at = tangent;
  for (int step = 0; step <= o->plan->mode_count; step++) {
    tp_near most = at;
    for (int k = 0; k < o->plan->mode_count; k++) {
      const tp_near_interval *own = &o->modes[k].all;
      if (!tp_filter_holds(own, at)) continue;
      if (!own->has_high) return true;
      if (tp_near_sign(tp_near_sub(own->high, most)) > 0) most = own->high;
    }
    if (tp_near_sign(tp_near_sub(most, wanted)) > 0) return true;
    if (tp_near_sign(tp_near_sub(most, at)) <= 0) return false;
    at = tp_near_mul(most, (tp_near){1 + beside, 0});
  }
  return false;
}

/* Does the window that holds the tilt begin at the onset, and end where the factor by its upper
 * end, that of the tilts, is less than one at hand? */
static bool begins_at_onset(const tp_case_told *told, tp_near tangent, tp_near fos) {
  return tp_filter_begins_from(told, told->onset.tangent, tangent) == TP_FILTER_COUNTS &&
         reaches(&told->onset, tangent, tp_near_div(tangent, fos));
}

/* Of a block that moves whatever its strength, in the window that begins at the onset, the nearer
 * of its ends: by the tilt. */
static bool take_onset(least *l, const tp_case_told *told, const tp_filter_state *s) {
  if (told->never) return false;
  const tp_near fos = tp_near_div(told->onset.tangent, s->tangent);
  return begins_at_onset(told, s->tangent, fos) &&
         take(l, TP_FOS_NUMBER, fos, TP_FOS_BY_TILT, s->mover);
}

/* What governs may be that number as well, from which it is not told apart. */
static void widen(least *l, tp_near fos) {
  const tp_near lower = tp_near_lesser(l->fos, fos), own = l->fos;
  const double low = fmin(lower.value - lower.error, own.value - own.error);
  const double high = fmax(lower.value + lower.error, own.value + own.error);
  l->fos =
      tp_near_of(low + (high - low) / 2, (high - low) / 2 + (fabs(low) + fabs(high)) * DBL_EPSILON);
}

/* Of a block that moves what comes nearer to 1; where no change of strength stops it, and nothing
 * else would, the tilt. */
static bool take_strength(least *l, const tp_case_told *told, const tp_filter_state *s) {
  tp_strength_told own;
  const double most =
      l->number && !s->moves ? (l->fos.value + l->fos.error) * (1 + 0x1p-30) : INFINITY;
  if (!tp_strength_filter_find(&own, &told->of, s->tangent, s->moves, most)) return false;
  if (own.farther) {
    const int order = order_of_tilt(l, told, s);
    if (order == 0) widen(l, tp_near_div(told->onset.tangent, s->tangent));
    if (order >= 0 || tp_strength_filter_needs_some(&told->of, s->tangent)) return true;
    if (!tp_strength_filter_find(&own, &told->of, s->tangent, false, INFINITY)) return false;
    if (own.found) return true;
  }
  if (!own.found && s->moves) return l->number || take_onset(l, told, s);
  if (!own.found) return take_tilt(l, told, s);
  const bool raised = own.share.value > 1;
  const tp_near fos = raised == s->moves ? tp_near_div((tp_near){1, 0}, own.share) : own.share;
  if (!s->moves) return take(l, TP_FOS_NUMBER, fos, TP_FOS_BY_REDUCTION, own.mechanism);
  const int order = l->number ? tp_near_sign(tp_near_sub(fos, l->fos)) : 1;
  if (order == 0) {
    l->fos = tp_near_larger(l->fos, fos);
    return l->mechanism == s->mover;
  }
  if (order < 0) return true;
  name(l, TP_FOS_BY_REDUCTION, s->mover);
  l->fos = fos;
  l->any = l->number = true;
  return true;
}

/* Of a block that stands, may the tilt at which another window begins, above that of the onset,
 * tell less than what governs? */
static bool is_told_beyond(const least *l, const tp_case_told *told, tp_near tangent) {
  static const double beside = 0x1p-30;
  const tp_near above = tp_near_mul(told->onset.tangent, (tp_near){1 + beside, 0});
  return reaches(&told->onset, above, tp_near_mul(l->fos, tangent));
}

/* Where the tilt tells beside a change of strength, as at an end of a window that strength does not
 * move and at which no formula is 1, balls do: that of a gap or of the window that begins at the
 * onset is known. */
static bool is_told_without_tilt(const least *l, const tp_case_told *told,
                                 const tp_filter_state *s) {
  if (!l->number || told->never || tp_near_is_zero(s->tangent)) return true;
  if (s->moves && !begins_at_onset(told, s->tangent, l->fos)) return false;
  const tp_near fos = tp_near_div(told->onset.tangent, s->tangent);
  const int order = tp_near_sign(tp_near_sub(fos, l->fos));
  if (s->moves ? order <= 0 : order >= 0) return true;
  if (!s->moves && !is_told_beyond(l, told, s->tangent)) return false;
  if (l->perhaps_at_onset) return l->at_onset;
  return tp_strength_filter_moves_onset(&told->of, told->onset.tangent);
}

/* Between windows of motion, where the tilt may tell, balls do. */
static bool lies_between_windows(const tp_case_told *told, const tp_filter_state *s) {
  return !s->moves && !told->never &&
         tp_near_sign(tp_near_sub(told->onset.tangent, s->tangent)) <= 0;
}

bool tp_factor_filter(tp_case_told_at *at, const tp_case_told *told, const tp_filter_state *s) {
  least l = {.any = false};
  if (lies_between_windows(told, s) || !take_moments(&l, &at->by_moments, told, s) ||
      !take_sliding(&l, &at->by_shear, told, s) || !take_strength(&l, told, s) ||
      !is_told_without_tilt(&l, told, s)) {
    return false;
  }
  if (!l.any) name(&l, TP_FOS_BY_REDUCTION, TP_MECHANISM_UNDECIDED);
  at->fos = (tp_fos_told){l.number ? TP_FOS_NUMBER : TP_FOS_NO_OVERTURNING, l.fos};
  at->fos_mechanism = l.mechanism;
  at->fos_definition = l.definition;
  return true;
}
