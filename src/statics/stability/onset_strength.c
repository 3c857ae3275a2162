/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Asks motion/strength_change.h at the scene's tilt, and writes the factor of the onset and whether
 * the ends of the windows beside the tilt move with strength (docs/mechanics.md section 6). */

#include "stability/onset_strength.h"

#include "motion/strength_change.h"
#include "stability/friction.h"

#include <math.h>

bool tp_onset_asks_strength(const tp_evaluation *e) {
  return e->reduces_strength && e->problem->scene->tilt_angle_deg.given;
}

/* With which strength forces just hold it, as the limit tells: where that is not known, the modes
 * alone. */
static void ask_limit(tp_strength_asked *a, arb_t held, const tp_limit *limit, long bits) {
  const tp_fos *fos = &limit->fos;
  a->held = held;
  a->lost = limit->fos_mechanism;
  a->all_is_lost = fos->state == TP_FOS_UNDEFINED;
  a->is_held = fos->state != TP_FOS_NUMBER || fos->value.value <= fos->value.error;
  if (a->is_held) return;
  mag_t error;
  mag_init(error);
  arb_set_d(held, fos->value.value);
  mag_set_d(error, fos->value.error);
  arb_add_error_mag(held, error);
  arb_inv(held, held, bits);
  mag_clear(error);
  arb_t one;
  arb_init(one);
  arb_one(one);
  a->can_begin = a->can_begin || arb_lt(one, held);
  arb_clear(one);
}

static void tell(tp_onset *onset, const tp_strength_change *change, const tp_evaluation *e,
                 bool can_begin) {
  onset->fos_mechanism = change->mechanism;
  if (!change->found) {
    onset->fos.state = can_begin ? TP_FOS_UNDEFINED : TP_FOS_NO_OVERTURNING;
    return;
  }
  arb_t factor;
  arb_init(factor);
  if (change->raised == can_begin) {
    arb_inv(factor, change->share, e->rung.bits);
  } else {
    arb_set(factor, change->share);
  }
  onset->fos = (tp_fos){TP_FOS_NUMBER, tp_result_of(e, factor)};
  onset->fos_raised = change->raised;
  arb_clear(factor);
}

/* Does a change of strength move an end of a window? Just inside it little of it then ends what can
 * begin; where it does not, or nothing tells, it takes much. */
static tp_motion_outcome is_by_strength(bool *by_strength, const tp_strength_asked *asked,
                                        const arb_t end, double inwards) {
  tp_strength_asked a = *asked;
  arb_t inside;
  double share = 0;
  arb_init(inside);
  arb_set_d(inside, inwards * TP_BESIDE_END_DEG);
  arb_add(inside, inside, end, a.question->judge.bits);
  mag_zero(arb_radref(inside)); /* any tilt there will do */
  a.degrees = inside;
  a.can_begin = a.is_held = true; /* by the modes alone */
  const tp_motion_outcome done = tp_strength_change_of_modes(&share, &a);
  *by_strength = done != TP_MOTION_PROVEN || (share > 0 && fabs(log(share)) < TP_LITTLE_STRENGTH);
  arb_clear(inside);
  return done == TP_MOTION_OUT_OF_MEMORY ? done : TP_MOTION_PROVEN;
}

static bool begins_above(const tp_motion_window *w, const arb_t degrees) {
  return !w->from.endless && arb_gt(w->from.degrees, degrees);
}

static bool ends_below(const tp_motion_window *w, const arb_t degrees) {
  return !w->to.endless && arb_lt(w->to.degrees, degrees);
}

/* Of the ends of windows next to the tilt: of the window that holds it, or of the gap. */
static tp_motion_outcome set_by_strength(const tp_onset_telling *t, const tp_strength_asked *a) {
  const tp_motion_windows *windows = t->windows;
  tp_onset *onset = &t->result->onset;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long k = 0; k < windows->count && done == TP_MOTION_PROVEN; k++) {
    const tp_motion_window *w = windows->items + k;
    const bool after = begins_above(w, a->degrees), before = ends_below(w, a->degrees);
    const bool first = k == 0 || !begins_above(w - 1, a->degrees);
    const bool last = k + 1 == windows->count || !ends_below(w + 1, a->degrees);
    tp_window *own = onset->windows + k;
    if (!w->from.endless && !before && (!after || first)) {
      done = is_by_strength(&own->from_by_strength, a, w->from.degrees, 1);
    }
    if (!w->to.endless && !after && (!before || last) && done == TP_MOTION_PROVEN) {
      done = is_by_strength(&own->to_by_strength, a, w->to.degrees, -1);
    }
  }
  return done;
}

tp_motion_outcome tp_onset_strength(const tp_onset_telling *t, tp_onset_asked *asked,
                                    const arb_t tilt, bool can_begin) {
  tp_onset *onset = &t->result->onset;
  tp_strength_change change;
  arb_t held;
  arb_init(held);
  tp_strength_change_init(&change);
  tp_strength_asked a = {.question = &asked->question,
                         .cones = &asked->cones,
                         .strong = asked->question.strong != NULL ? &asked->strong : NULL,
                         .motions = t->motions,
                         .degrees = tilt,
                         .can_begin = can_begin,
                         .digits = t->e->digits};
  ask_limit(&a, held, &t->result->limit, t->e->rung.bits);
  a.can_begin = a.can_begin || a.all_is_lost;
  tp_motion_outcome done = tp_strength_change_find(&change, &a);
  onset->fos = (tp_fos){.state = TP_FOS_UNDECIDED};
  onset->fos_mechanism = TP_MECHANISM_UNDECIDED;
  if (done == TP_MOTION_PROVEN) tell(onset, &change, t->e, a.can_begin);
  if (done == TP_MOTION_PROVEN && !tp_friction_is_load_dependent(t->e)) {
    done = set_by_strength(t, &a);
  }
  tp_strength_change_clear(&change);
  arb_clear(held);
  return done;
}
