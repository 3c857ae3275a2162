/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilts at which motions can begin, in doubles with bounds. */

#ifndef TP_CASE_FILTER_ONSET_FILTER_H
#define TP_CASE_FILTER_ONSET_FILTER_H

#include "case_filter/mode_capacities.h"
#include "case_filter/near_interval.h"

typedef struct tp_onset_filter {
  const tp_contact_plan *plan;
  tp_near_interval leaves;
  tp_mode_interval modes[TP_PLAN_MODES];
  bool never;       /* no motion can begin at any tilt up to 90 degrees */
  tp_near tangent;  /* else of the onset */
  bool has_perhaps; /* something may begin, or not, */
  tp_near perhaps;  /* from here on */
} tp_onset_filter;

/* False where doubles do not tell, or where a motion can begin on level ground. */
bool tp_onset_filter_find(tp_onset_filter *found, const tp_filter_case *of);

/* The modes alone: where each can begin. False where doubles do not tell. */
bool tp_onset_filter_modes(tp_onset_filter *found, const tp_filter_case *of);

/* The end of a window of motion next to a tilt: the lower one of the window that holds it, or else
 * of the next one above it. False where doubles do not tell, or where the window has no lower end.
 */
bool tp_onset_filter_end(bool *never, tp_near *end, const tp_onset_filter *found, tp_near tangent,
                         bool moves);

/* Can a motion begin at the tilt, and which: the bit 1 << mechanism of each. False where doubles do
 * not tell. */
bool tp_onset_filter_look(bool *moves, unsigned *beginnings, const tp_onset_filter *found,
                          tp_near tangent);

#endif
