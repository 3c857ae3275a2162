/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Further tilts of a scene that is solved at its own. Neither the angle of the limit nor the
 * windows of the onset depend on the tilt: they are found once, and what a tilt has of them is told
 * of each.
 *
 * That is done at the first rung of the ladder alone: where all is certain there, a solve of its
 * own at the tilt would have found the same, and ended. Else the tilt is left to such a solve, also
 * where so much work is spent that the bound on all of it might matter. */

#ifndef TP_EVALUATION_FURTHER_H
#define TP_EVALUATION_FURTHER_H

#include "evaluation/certainty.h"

/* One of them, of the case in hand. */
typedef struct tp_further_tilt {
  const tp_evaluation *e; /* of a scene that differs in its tilt; counts work of its own */
  tp_case *result;
  struct tp_onset_found *onset;
  tp_certainty *certainty;
} tp_further_tilt;

typedef struct tp_further_tilts {
  size_t count;
  tp_further_tilt *items;
} tp_further_tilts;

/* Its work goes on from there. */
void tp_further_begin(const tp_further_tilt *tilt, const tp_work *spent);
/* Too much of it leaves the tilt open. */
void tp_further_end(const tp_further_tilt *tilt);
/* Is so little spent that no bound on the sum can matter? */
bool tp_further_is_cheap(const tp_work *work);

#endif
