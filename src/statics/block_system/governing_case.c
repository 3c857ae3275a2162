/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each case has two factors, by strength and by what drives, with the earthquake and without. Their
 * upper bounds are proven motions, and numbers beyond which no forces hold the blocks; their lower
 * bounds are numbers up to which every motion is excluded. */

#include "block_system/governing_case.h"

#include "block_system/state_limits.h"

#include <math.h>

static double high(tp_bounded number) {
  return number.value + number.error;
}

static double low(tp_bounded number) {
  return number.value - number.error;
}

/* ---- bounds ------------------------------------------------------------------------------------
 */

static bool moves(const tp_system_case *c) {
  return c->verdict == TP_SYSTEM_COLLAPSES || c->verdict == TP_SYSTEM_MAY_MOVE;
}

/* The mechanism stays where it is not known, and that before begins at the same number, to digits
 * that are printed. */
static void take_most(tp_system_bounds *b, double most, tp_mechanism mechanism) {
  static const double near = 1e-5;
  if (!(most < b->at_most)) return;
  const bool is_same = most >= b->at_most * (1 - near);
  b->at_most = most;
  if (mechanism != TP_STANDS || !is_same) b->mechanism = mechanism;
}

/* Beyond a limit of what forces can hold a motion begins. */
static void take_limit(tp_system_bounds *b, const tp_fos *limit, bool is_least,
                       tp_mechanism mechanism) {
  if (limit->state == TP_FOS_NUMBER && !is_least) {
    take_most(b, nextafter(high(limit->value), INFINITY), mechanism);
  }
}

/* Of a motion that was found the mechanism is known already. */
static tp_mechanism begin(tp_system_bounds *b) {
  const tp_mechanism moving = b->mechanism;
  *b = (tp_system_bounds){.counts = true, .at_most = INFINITY};
  return moving;
}

/* The motion itself is told of, not the one of limit analysis, where both begin there. */
static void take_motion(tp_system_bounds *b, double moving, tp_mechanism mechanism) {
  static const double near = 1e-5;
  take_most(b, moving, mechanism);
  if (mechanism != TP_STANDS && moving <= b->at_most * (1 + near)) b->mechanism = mechanism;
}

static void bound_strength(tp_system_case *c) {
  tp_system_bounds *b = &c->fos_by_strength;
  const tp_mechanism start =
      tp_system_motions_mechanism(c->start.motions, c->has_start ? c->start.motion_count : 0);
  const bool helps_not = moves(c) && (c->moving_fos_is_most || c->fos.state == TP_FOS_UNDEFINED);
  (void)begin(b);
  if (helps_not) { /* no strength stops the motion */
    *b = (tp_system_bounds){.at_most = INFINITY};
    return;
  }
  take_limit(b, &c->fos, c->fos_is_least, tp_system_case_mechanism(c));
  if (c->has_moving_fos) take_motion(b, c->moving_fos, start);
  if (c->verdict == TP_SYSTEM_STANDS && c->has_standing_fos) {
    b->at_least = fmax(b->at_least, c->standing_fos);
  }
}

static void bound_driving(tp_system_case *c) {
  tp_system_bounds *b = &c->fos_by_driving;
  const tp_fos *limit = &c->fos_driving;
  const tp_mechanism moving = begin(b);
  take_limit(b, limit, c->fos_driving_is_least, c->fos_driving_mechanism);
  if (c->has_moving_fos_driving) take_motion(b, c->moving_fos_driving, moving);
  if (c->verdict == TP_SYSTEM_STANDS && c->has_standing_fos_driving) {
    b->at_least = fmax(b->at_least, c->standing_fos_driving);
  }
  if (limit->state == TP_FOS_UNDEFINED && moves(c)) b->at_least = b->at_most = 0;
  if (limit->state != TP_FOS_NO_OVERTURNING) return;
  if (moves(c)) {
    *b = (tp_system_bounds){.at_most = INFINITY}; /* no load decides it */
  } else if (c->verdict == TP_SYSTEM_STANDS) {
    b->at_least = INFINITY;
  }
}

void tp_system_case_settle_bounds(tp_system_case *c) {
  if (!moves(c) || c->fos_by_strength.counts || c->fos_by_driving.counts) return;
  c->fos_by_driving = (tp_system_bounds){.counts = true};
}

void tp_system_case_set_bounds(tp_system_case *c) {
  bound_strength(c);
  bound_driving(c);
  tp_system_case_settle_bounds(c);
}

void tp_system_case_take_motion(tp_system_case *c, tp_system_verdict before) {
  if (c->verdict != before) {
    tp_system_case_set_bounds(c);
  } else if (c->has_moving_fos && c->fos_by_strength.counts) {
    take_motion(
        &c->fos_by_strength, c->moving_fos,
        tp_system_motions_mechanism(c->start.motions, c->has_start ? c->start.motion_count : 0));
  }
}

/* ---- the rule ----------------------------------------------------------------------------------
 */

static tp_motion_verdict verdict_of(tp_system_verdict verdict) {
  switch (verdict) {
  case TP_SYSTEM_STANDS:
    return TP_VERDICT_STANDS;
  case TP_SYSTEM_MAY_MOVE:
    return TP_VERDICT_CAN_MOVE;
  case TP_SYSTEM_COLLAPSES:
    return TP_VERDICT_COLLAPSES;
  case TP_SYSTEM_CAN_HOLD:
  case TP_SYSTEM_UNDECIDED:
    break;
  }
  return TP_VERDICT_OPEN;
}

static tp_factor_range range_of(const tp_system_bounds *b, tp_fos_definition definition) {
  return (tp_factor_range){definition, b->mechanism, b->at_least, b->at_most};
}

enum { BOTH = 2 };

/* The ranges of those that count. */
static tp_safety state_of(tp_factor_range ranges[BOTH], tp_system_verdict verdict,
                          const tp_system_bounds *strength, const tp_system_bounds *driving) {
  size_t count = 0;
  if (driving->counts) ranges[count++] = range_of(driving, TP_FOS_BY_DRIVING);
  if (strength->counts) ranges[count++] = range_of(strength, TP_FOS_BY_REDUCTION);
  return tp_safety_of(verdict_of(verdict), ranges, count);
}

/* The states of a case, with the earthquake first, and the ranges that they are of. */
typedef struct states {
  tp_factor_range ranges[BOTH][BOTH];
  tp_safety of[BOTH];
  size_t count;
} states;

static states states_of(const tp_system_case *c) {
  states s = {.count = c->has_static ? 2 : 1};
  s.of[0] = state_of(s.ranges[0], c->verdict, &c->fos_by_strength, &c->fos_by_driving);
  if (c->has_static) {
    s.of[1] = state_of(s.ranges[1], c->static_verdict, &c->static_fos_by_strength,
                       &c->static_fos_by_driving);
  }
  return s;
}

tp_safety tp_system_case_rule(const tp_system_case *c) {
  const states s = states_of(c);
  return tp_safety_of_all(s.of, s.count);
}

/* Where both definitions have one factor, as of what slides, strength is told of. */
static void prefer_strength(tp_system_case *c, bool is_static) {
  static const double same = 1e-5;
  const tp_system_bounds *strength = is_static ? &c->static_fos_by_strength : &c->fos_by_strength;
  const tp_system_bounds *driving = is_static ? &c->static_fos_by_driving : &c->fos_by_driving;
  if (!strength->counts || !(strength->at_most <= driving->at_most * (1 + same))) return;
  c->governing_fos.definition = TP_FOS_BY_REDUCTION;
  c->governing_fos.mechanism = strength->mechanism;
}

void tp_system_case_set_safety(tp_system_case *c) {
  const states s = states_of(c);
  const size_t governing = tp_safety_governing(s.of, s.count);
  const tp_safety all = tp_safety_of_all(s.of, s.count);
  /* the factor that is the least, which may be that of the other state */
  size_t least = governing;
  for (size_t k = 0; k < s.count; k++) {
    if (s.of[k].has_factor && s.of[k].most < s.of[least].most) least = k;
  }
  const tp_factor_range *range =
      s.of[least].has_factor ? &s.ranges[least][s.of[least].factor] : NULL;
  c->governing_fos = (tp_system_safety){.fos = tp_safety_fos(&all),
                                        .at_least = all.least,
                                        .at_most = all.most,
                                        .has_definition = range != NULL,
                                        .without_earthquake = least == 1};
  if (range != NULL) {
    c->governing_fos.definition = range->definition;
    c->governing_fos.mechanism = range->mechanism;
    prefer_strength(c, least == 1);
  }
}

bool tp_system_case_is_worse(const tp_system_case *one, const tp_system_case *other) {
  const tp_safety a = tp_system_case_rule(one), b = tp_system_case_rule(other);
  return tp_safety_compare(&a, &b) < 0;
}

const tp_system_case *tp_system_most_severe(const tp_block_system *s) {
  const tp_system_case *worst = s->cases;
  for (size_t k = 1; k < s->case_count; k++) {
    if (tp_system_case_is_worse(s->cases + k, worst)) worst = s->cases + k;
  }
  return worst;
}

/* Where no motion is known that can begin, the case that bounds the factor from above: one that is
 * open is no news beside that. */
void tp_block_system_set_safety(tp_block_system *s) {
  const tp_system_case *worst = tp_system_most_severe(s);
  tp_safety all = tp_system_case_rule(worst);
  s->governing = (size_t)(worst - s->cases);
  for (size_t k = 0; k < s->case_count && all.verdict >= TP_VERDICT_OPEN; k++) {
    const double most = s->cases[k].governing_fos.at_most;
    if (most < s->cases[s->governing].governing_fos.at_most) s->governing = k;
  }
  s->governing_fos = s->cases[s->governing].governing_fos;
  for (size_t k = 0; k < s->case_count; k++) {
    all.least = fmin(all.least, s->cases[k].governing_fos.at_least);
    all.most = fmin(all.most, s->cases[k].governing_fos.at_most);
  }
  s->governing_fos.fos = tp_safety_fos(&all);
  s->governing_fos.at_least = all.least;
  s->governing_fos.at_most = all.most;
}

const tp_system_case *tp_system_governing(const tp_block_system *system) {
  return system->cases + system->governing;
}

/* ---- what is known of a case -------------------------------------------------------------------
 */

bool tp_system_case_is_held_farther(const tp_system_case *c) {
  return c->verdict == TP_SYSTEM_COLLAPSES && c->limit == TP_SYSTEM_LIMIT_NUMBER &&
         low(c->critical_angle_deg) > high(c->tilt_angle_deg);
}

tp_mechanism tp_system_motions_mechanism(const tp_system_motion *motions, size_t count) {
  bool slides = false, topples = false;
  for (size_t k = 0; k < count; k++) {
    const tp_mechanism mechanism = motions[k].mechanism;
    slides = slides || mechanism == TP_SLIDES || mechanism == TP_SLIDES_AND_TOPPLES;
    topples = topples || mechanism == TP_TOPPLES || mechanism == TP_SLIDES_AND_TOPPLES;
  }
  return slides && topples ? TP_SLIDES_AND_TOPPLES
         : slides          ? TP_SLIDES
         : topples         ? TP_TOPPLES
                           : TP_STANDS;
}

tp_mechanism tp_system_case_mechanism(const tp_system_case *c) {
  return tp_system_motions_mechanism(c->motions, c->motion_count);
}

tp_system_verdict tp_system_case_worst_verdict(const tp_system_case *c) {
  const bool less = c->has_static && verdict_of(c->static_verdict) < verdict_of(c->verdict);
  return less ? c->static_verdict : c->verdict;
}

bool tp_system_case_moves_at_rest(const tp_system_case *c) {
  return verdict_of(c->has_static ? c->static_verdict : c->verdict) < TP_VERDICT_OPEN;
}

bool tp_system_case_is_unexamined(const tp_system_case *own) {
  return own->sought == TP_SYSTEM_SOUGHT_TOO_MANY && own->verdict != TP_SYSTEM_STANDS;
}

bool tp_system_case_moves_sooner(const tp_system_case *own) {
  const bool is_known = own->fos.state == TP_FOS_NUMBER && !own->fos_is_least;
  return own->has_moving_fos &&
         (!is_known || own->moving_fos < own->fos.value.value - own->fos.value.error);
}
