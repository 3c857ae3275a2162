/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bound of the work that further tilts may share, so that no tilt gets less than a separate solve
 * would have. */

#include "stability/further.h"

/* A question may take a quarter of what is allowed (number/work.c): with an eighth for the scene's
 * own tilt and one for each part of a further one the sum stays below what is allowed. */
bool tp_further_is_cheap(const tp_work *work) {
  static const double share = 0.125;
  return work->spent <= share * tp_work_allowed(0);
}

void tp_further_begin(const tp_further_tilt *tilt, const tp_work *spent) {
  *tilt->e->work = *spent;
}

void tp_further_end(const tp_further_tilt *tilt) {
  if (!tp_further_is_cheap(tilt->e->work)) tilt->certainty->open = true;
}
