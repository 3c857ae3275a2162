/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mechanism that is reached first as the table is tilted, by formulas, static limit and onset,
 * the mechanism at the scene's tilt, motion up-dip, and the margin (docs/mechanics.md sections 3
 * and 6a). */

#include "evaluation/loaded.h"
#include "evaluation/stages.h"
#include "onset/onset.h"
#include "onset/onset_question.h"

#include "number/ball.h"

/* Sign of the angle minus 90 degrees. */
static int against_upright(const tp_evaluation *e, const tp_direction_ball *angle,
                           tp_certainty *certainty) {
  tp_direction_ball upright;
  tp_direction_ball_init(&upright);
  arb_one(upright.sine);
  arb_set_ui(upright.degrees, 90);
  upright.exact_direction = true;
  const int side = tp_direction_ball_compare(e, angle, &upright, certainty);
  tp_direction_ball_clear(&upright);
  return side;
}

/* By the formulas of moments and of sliding, where no friction is given or its limit is no angle.
 */
static const tp_direction_ball *first_by_formula(const tp_evaluation *e, tp_case *result,
                                                 const tp_direction_ball *toppling,
                                                 const tp_direction_ball *sliding,
                                                 tp_certainty *certainty) {
  const bool topples = result->has_toppling_pivot && against_upright(e, toppling, certainty) < 0;
  const bool slides = result->sliding.known && !result->sliding.never;
  const bool topples_always = topples && result->pivots[result->toppling_pivot].always;
  const bool slides_always = slides && result->sliding.always;
  if (topples_always || slides_always) {
    result->first = !slides_always    ? TP_TOPPLES
                    : !topples_always ? TP_SLIDES
                                      : TP_SLIDES_AND_TOPPLES;
    return NULL;
  }
  if (topples && slides) {
    const int side = tp_direction_ball_compare(e, toppling, sliding, certainty);
    result->first = side < 0 ? TP_TOPPLES : side > 0 ? TP_SLIDES : TP_SLIDES_AND_TOPPLES;
    return side > 0 ? sliding : toppling;
  }
  if (topples || slides) {
    result->first = topples ? TP_TOPPLES : TP_SLIDES;
    return topples ? toppling : sliding;
  }
  result->first = result->sliding.known ? TP_INTERLOCKED : TP_STANDS;
  return NULL;
}

/* Contact forces let a bond pull at one point and press at another, which counts as friction of
 * tan(phi) times the bond. Where nothing but friction and cohesion holds a block that slips, that
 * is more than the scene gives it: then it slides where the forces along the facet say so. That
 * needs one friction: of several the forces along the facet know the least alone. */
static bool slides_sooner(const tp_evaluation *e, const tp_case *result, tp_certainty *certainty) {
  const tp_sliding *s = &result->sliding;
  if (fmpq_is_zero(e->problem->scene->loads.bond_kpa.value) || !s->known || s->never ||
      e->problem->friction.uneven ||
      !tp_contact_is_free_to_slip(&e->problem->contact, &e->problem->lattice)) {
    return false;
  }
  if (result->limit.kind == TP_LIMIT_INTERLOCKED) return true;
  if (result->limit.kind != TP_LIMIT_AT_ANGLE) return false;
  return s->always || tp_result_is_above(e, result->limit.critical_angle_deg, s->critical_angle_deg,
                                         certainty); /* of a tie the limit tells */
}

/* Where nothing holds it at any tilt, what begins. */
static tp_mechanism first_of_nothing(const tp_evaluation *e, const tp_case *result) {
  if (!tp_contact_restrains(&e->problem->contact)) return TP_LEAVES_BASE;
  switch (result->onset.kind) {
  case TP_ONSET_NOWHERE:
    return result->onset.mechanism;
  case TP_ONSET_UNDECIDED:
    return TP_MECHANISM_UNDECIDED;
  default:
    return TP_SLIDES_AND_TOPPLES;
  }
}

/* Where some forces hold it at every tilt, but a motion can begin, that is the first to tell. */
static const tp_direction_ball *first_of_interlocked(tp_case *result,
                                                     const tp_direction_ball *onset) {
  const tp_onset_kind kind = result->onset.kind;
  result->first = kind == TP_ONSET_AT_ANGLE || kind == TP_ONSET_NOWHERE ? TP_MAY_MOVE
                  : kind == TP_ONSET_UNDECIDED                          ? TP_MECHANISM_UNDECIDED
                                                                        : TP_INTERLOCKED;
  return kind == TP_ONSET_AT_ANGLE ? onset : NULL;
}

/* By statics. */
static const tp_direction_ball *find_first(const tp_evaluation *e, tp_case *result,
                                           const tp_statics *statics,
                                           const tp_direction_ball *onset,
                                           tp_certainty *certainty) {
  result->slides_sooner = slides_sooner(e, result, certainty);
  if (result->slides_sooner && !result->sliding.always && result->onset.kind == TP_ONSET_AT_ANGLE) {
    result->onset.below_limit = tp_result_is_above(e, result->sliding.critical_angle_deg,
                                                   result->onset.critical_angle_deg, certainty);
  }
  if (result->slides_sooner) {
    result->first = TP_SLIDES;
    return result->sliding.always ? NULL : statics->sliding;
  }
  switch (result->limit.kind) {
  case TP_LIMIT_AT_ANGLE:
    result->first = result->limit.tie ? TP_SLIDES_AND_TOPPLES : result->limit.mechanism;
    return statics->limit;
  case TP_LIMIT_INTERLOCKED:
    return first_of_interlocked(result, onset);
  case TP_LIMIT_NOWHERE:
    result->first = first_of_nothing(e, result);
    return NULL;
  case TP_LIMIT_UNDECIDED:
    result->first = TP_MECHANISM_UNDECIDED;
    return NULL;
  case TP_LIMIT_NOT_ASKED:
    break;
  }
  return first_by_formula(e, result, statics->toppling, statics->sliding, certainty);
}

/* Is the tilt below zero, turned back, beyond this angle? */
static bool lies_before(const tp_evaluation *e, const arb_t tilt, const arb_t back,
                        tp_certainty *certainty) {
  arb_t sum;
  arb_init(sum);
  arb_add(sum, back, tilt, e->rung.bits);
  const bool before = arb_is_negative(sum) != 0;
  if (!before && !arb_is_nonnegative(sum)) certainty->open = true;
  arb_clear(sum);
  return before;
}

/* By contact forces. From which tilt they hold it may be open. */
static void judge_up_dip(const tp_evaluation *e, tp_case *result, const tp_direction_ball *back,
                         const arb_t tilt, tp_certainty *certainty) {
  const tp_limit *l = &result->limit_holds_from;
  if (l->kind == TP_LIMIT_UNDECIDED) {
    result->mechanism = TP_MECHANISM_UNDECIDED;
    if (result->first == TP_INTERLOCKED) result->first = TP_MECHANISM_UNDECIDED;
    result->limit.fos = (tp_fos){.state = TP_FOS_UNDECIDED};
    return;
  }
  result->falls_backwards =
      l->kind == TP_LIMIT_AT_ANGLE && lies_before(e, tilt, back->degrees, certainty);
  if (result->falls_backwards) result->mechanism = l->tie ? TP_SLIDES_AND_TOPPLES : l->mechanism;
}

/* By moments: is the centroid past the up-dip end of the contact? Under loads the last rung may
 * leave it open. */
static bool topples_up_dip(bool *open, const tp_evaluation *e, tp_direction towards,
                           const arb_t tilt, tp_certainty *certainty) {
  const tp_direction other = towards == TP_TOWARDS_LEFT ? TP_TOWARDS_RIGHT : TP_TOWARDS_LEFT;
  if (e->loaded != NULL)
    return tp_loaded_falls_backwards(open, e->loaded, e, e->problem->admissible[other], certainty);
  tp_direction_ball angle;
  tp_direction_ball_init(&angle);
  const bool falls = tp_evaluate_toppling(e, other, &angle, certainty).found &&
                     lies_before(e, tilt, angle.degrees, certainty);
  tp_direction_ball_clear(&angle);
  return falls;
}

/* An angle less the scene's tilt; of two rationals exactly. */
static void set_margin(arb_t margin, const tp_evaluation *e, const tp_direction_ball *angle) {
  const tp_scene *scene = e->problem->scene;
  const long bits = e->rung.bits;
  fmpq_t rest;
  fmpq_init(rest);
  if (angle->adds != NULL) fmpq_set(rest, angle->adds);
  fmpq_sub(rest, rest, scene->tilt_angle_deg.value);
  arb_set_fmpq(margin, rest, bits);
  arb_add(margin, margin, angle->adds != NULL ? angle->inclination : angle->degrees, bits);
  fmpq_clear(rest);
}

/* To the first tilt from which it is not certain to stand: the onset, where that lies below what
 * happens first, or nothing happens for certain. */
static void judge_margin(const tp_evaluation *e, tp_case *result, const tp_direction_ball *first,
                         const tp_direction_ball *onset, tp_certainty *certainty) {
  const tp_onset_kind kind = result->onset.kind;
  result->has_margin = result->has_margin_to_first;
  result->margin_deg = result->margin_to_first_deg;
  if (kind == TP_ONSET_NOWHERE || kind == TP_ONSET_UNDECIDED) result->has_margin = false;
  if (kind != TP_ONSET_AT_ANGLE || !e->problem->scene->tilt_angle_deg.given) return;
  if (first != NULL && !result->onset.below_limit) return;
  arb_t margin;
  arb_init(margin);
  set_margin(margin, e, onset);
  result->has_margin = true;
  result->margin_deg = tp_result(e, margin, certainty);
  arb_clear(margin);
}

/* Where forces would hold it: certain to stand only if no motion can begin. Without a tilt `first`
 * says it all. */
static void judge_onset(const tp_evaluation *e, tp_case *result, const tp_onset_found *onset,
                        tp_certainty *certainty) {
  tp_mechanism *m = &result->mechanism;
  const bool holds = *m == TP_STANDS || *m == TP_INTERLOCKED || *m == TP_MAY_MOVE;
  if (!holds || result->onset.kind == TP_ONSET_NOT_ASKED ||
      !e->problem->scene->tilt_angle_deg.given) {
    return;
  }
  if (onset->at_tilt == TP_YES) *m = TP_MAY_MOVE;
  if (onset->at_tilt == TP_OPEN) {
    *m = TP_MECHANISM_UNDECIDED;
    const bool told = result->onset.kind != TP_ONSET_UNDECIDED; /* else that is noted */
    if (told) tp_certainty_leave_open(certainty, e);
  }
  if (onset->at_tilt == TP_NO && *m == TP_MAY_MOVE) *m = TP_STANDS;
}

/* What moves begins by a motion that can begin at this tilt, not by that of the limit. */
static void judge_beginning(const tp_evaluation *e, tp_case *result) {
  tp_onset *onset = &result->onset;
  const tp_mechanism m = result->mechanism;
  const bool moves =
      m == TP_SLIDES || m == TP_TOPPLES || m == TP_SLIDES_AND_TOPPLES || m == TP_LEAVES_BASE;
  if (!moves) return;
  if (onset->beginning_count == 0) { /* beyond the limit some motion does, if by no mode */
    onset->has_motions = onset->has_motions && !tp_onset_has_strength(e);
    return;
  }
  for (size_t k = 0; k < onset->beginning_count; k++) {
    if (onset->beginnings[k] == m) return;
  }
  result->mechanism = onset->beginnings[0];
}

void tp_evaluate_mechanism(const tp_evaluation *e, tp_case *result, const tp_statics *statics,
                           tp_certainty *certainty) {
  const tp_quantity *tilt = &e->problem->scene->tilt_angle_deg;
  tp_direction_ball onset;
  tp_direction_ball_init(&onset);
  arb_set(onset.degrees, statics->onset->degrees);
  const tp_direction_ball *first = find_first(e, result, statics, &onset, certainty);
  arb_t angle, margin;
  arb_init(angle);
  arb_init(margin);
  arb_set_fmpq(angle, tilt->value, e->rung.bits); /* 0 where not given */
  result->mechanism = result->first;
  result->falls_backwards = false; /* whatever a lower rung took it for */
  result->has_margin_to_first = first != NULL && tilt->given;
  result->has_first_angle = first != NULL;
  if (first != NULL) result->first_angle_deg = tp_result(e, first->degrees, certainty);
  if (result->has_margin_to_first) {
    set_margin(margin, e, first);
    if (arb_is_positive(margin)) {
      result->mechanism = TP_STANDS;
    } else if (!arb_is_nonpositive(margin)) {
      tp_certainty_leave_open(certainty, e);
      result->mechanism = TP_MECHANISM_UNDECIDED;
    }
    result->margin_to_first_deg = tp_result(e, margin, certainty);
  }
  judge_margin(e, result, first, &onset, certainty);
  if (result->limit.kind == TP_LIMIT_AT_ANGLE || result->limit.kind == TP_LIMIT_INTERLOCKED) {
    judge_up_dip(e, result, statics->back, angle, certainty);
  } else if (result->limit.kind != TP_LIMIT_NOWHERE) { /* there is no way up-dip alone */
    bool open = false;
    result->falls_backwards = topples_up_dip(&open, e, result->towards, angle, certainty);
    if (result->falls_backwards) result->mechanism = TP_TOPPLES;
    if (open) result->mechanism = TP_MECHANISM_UNDECIDED;
  }
  judge_onset(e, result, statics->onset, certainty);
  judge_beginning(e, result);
  /* more friction would hold what slips up-dip, but that is not what the factor is about */
  if (result->falls_backwards) result->limit.fos = (tp_fos){.state = TP_FOS_NOT_ASKED};
  arb_clear(angle);
  arb_clear(margin);
  tp_direction_ball_clear(&onset);
}
