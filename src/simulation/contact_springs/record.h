/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The story of a run on contact springs: which contacts open and close, slip and stick, what the
 * block does as a whole, its moments and the reactions of the facets. Contacts are observed some
 * hundred times in sqrt(extent / g). A contact closes for the story when it bears a hundredth of
 * its share of the weight, and opens when it bore nothing in eight observations: less is vibration.
 */

#ifndef TP_CONTACT_SPRINGS_RECORD_H
#define TP_CONTACT_SPRINGS_RECORD_H

#include "contact_springs/stepper.h"
#include "rigid_body/history.h"

/* A contact that was closed when it was last observed. */
typedef struct tp_known_spring {
  tp_pair story;
  tp_xy at;
  long facet;
  bool slips, seen;
  int stuck, missing; /* observations in a row without slip, without a force */
  double opened_s;    /* when the first of those was */
} tp_known_spring;

typedef struct tp_spring_record {
  const tp_run *run;
  long count, room;
  tp_known_spring *known;
  double last_observed_s, next_moment_s;
} tp_spring_record;

/* Begin with the contacts that are closed, and the first moment. These return false when memory is
 * exhausted; without a history none of them does anything. */
TP_MUST_USE bool tp_spring_record_init(tp_spring_record *record, const tp_run *run,
                                       tp_stepper *stepper);
void tp_spring_record_clear(tp_spring_record *record);

/* Observe the contacts; a moment where one is due or something happened. */
TP_MUST_USE bool tp_spring_record_observe(tp_spring_record *record, tp_stepper *stepper);

/* What the whole block does, since a time; with a moment. */
TP_MUST_USE bool tp_spring_record_block(tp_spring_record *record, const tp_stepper *stepper,
                                        tp_tilt_event_kind kind, double since_s);

#endif
