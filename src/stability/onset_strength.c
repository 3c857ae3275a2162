/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/onset_strength.h"

#include "motion/strength_change.h"

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
  const tp_motion_outcome done = tp_strength_change_find(&change, &a);
  onset->fos = (tp_fos){.state = TP_FOS_UNDECIDED};
  onset->fos_mechanism = TP_MECHANISM_UNDECIDED;
  if (done == TP_MOTION_PROVEN) tell(onset, &change, t->e, a.can_begin);
  tp_strength_change_clear(&change);
  arb_clear(held);
  return done;
}
