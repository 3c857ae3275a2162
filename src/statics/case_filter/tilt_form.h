/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is linear in the loads, over the weight and cos(tilt), in doubles with bounds:
 * level + t rise + s fixed with t = tan(tilt), s = 1 / cos(tilt); `fixed` of loads that stay with
 * the block as it is tilted (docs/mechanics.md section 5). */

#ifndef TP_CASE_FILTER_TILT_FORM_H
#define TP_CASE_FILTER_TILT_FORM_H

#include "number/near.h"

typedef struct tp_tilt_form {
  tp_near level, rise, fixed;
} tp_tilt_form;

/* Its signs on level ground and towards upright, and where these differ the tangent of the one tilt
 * between the two at which it changes. */
typedef struct tp_tilt_change {
  int level, upright;
  tp_near tangent;
} tp_tilt_change;

/* False where doubles do not tell, or where the sign changes twice. */
bool tp_tilt_form_change(tp_tilt_change *change, const tp_tilt_form *form);

/* 1 / cos of the tilt with the tangent. */
tp_near tp_tilt_secant(tp_near tangent);

static inline tp_near tp_tilt_form_at(const tp_tilt_form *form, tp_near tangent, tp_near secant) {
  return tp_near_plus(tp_near_plus(form->level, tp_near_times(tangent, form->rise)),
                      tp_near_times(secant, form->fixed));
}

static inline tp_tilt_form tp_tilt_form_neg(tp_tilt_form form) {
  return (tp_tilt_form){tp_near_neg(form.level), tp_near_neg(form.rise), tp_near_neg(form.fixed)};
}

#endif
