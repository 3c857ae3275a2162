/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What must not be negative in a motion of given modes: openings, slips to their side, normal
 * forces, and friction in reserve where a contact sticks. Where that is certain of all, the motion
 * is proven. Where it is not, the modes of the contacts that are at fault are changed to the ones
 * that their laws ask for: a force that pulls opens its end, an end that would enter the other
 * block closes, a slip to the wrong side sticks, too much shear slips; and what is nothing but for
 * the roundings is tied, exactly nothing. */

#ifndef TP_CONTACT_MODES_MODE_LAWS_H
#define TP_CONTACT_MODES_MODE_LAWS_H

#include "contact_modes/mode_equations.h"

typedef enum tp_laws {
  TP_LAWS_HOLD,
  TP_LAWS_CHANGED, /* the trial has other modes now */
  TP_LAWS_BROKEN   /* nothing moves, certainly enough; or too many laws are broken */
} tp_laws;

/* Of equations that are solved; `trial` is what they were made of. */
tp_laws tp_mode_laws(tp_trial_mode *trial, const tp_mode_equations *equations);

#endif
