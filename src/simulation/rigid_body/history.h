/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a simulation writes down as it goes: events, moments, reactions (topple_tilt.h). */

#ifndef TP_RIGID_BODY_HISTORY_H
#define TP_RIGID_BODY_HISTORY_H

#include "rigid_body/drive.h"
#include "topple_tilt.h"

typedef struct tp_history {
  size_t event_count, event_room;
  tp_tilt_event *events;
  size_t moment_count, moment_room;
  tp_tilt_moment *moments;
  size_t reaction_count, reaction_room;
  tp_tilt_reaction *reactions;
} tp_history;

void tp_history_clear(tp_history *history);

/* Append; false when memory is exhausted. */
TP_MUST_USE bool tp_history_event(tp_history *history, tp_tilt_event event);
TP_MUST_USE bool tp_history_moment(tp_history *history, tp_tilt_moment moment);
TP_MUST_USE bool tp_history_reaction(tp_history *history, long facet, double normal_n,
                                     double shear_n); /* of the last moment */

/* How a run of a simulation ended. */
typedef enum tp_run_end {
  TP_RUN_STANDS, /* it rests where it began, or as close to that as its springs let it */
  TP_RUN_RESTS,  /* it moved, and rests again */
  TP_RUN_MOVES,  /* it was still in motion when the run ended */
  TP_RUN_OVERTURNED,
  TP_RUN_LEFT_BASE,
  TP_RUN_UNDECIDED, /* the bound on steps or events was reached before any of these was sure */
  TP_RUN_NO_MEMORY
} tp_run_end;

/* How far the block turned both ways during a run, in radians from its start, and when. */
typedef struct tp_turn_range {
  double most, most_s;   /* counter-clockwise, not below 0 */
  double least, least_s; /* clockwise, not above 0 */
} tp_turn_range;

/* A turn that was reached; NULL: nothing is kept. */
void tp_turn_range_take(tp_turn_range *range, double turned, double time_s);

/* What every simulation by dynamics is asked. */
typedef struct tp_run {
  const tp_rigid_body *body;
  const tp_drive *drive;
  tp_body_state start;
  double longest_s;       /* the run ends there */
  double moments_every_s; /* of the history; 0: at events alone */
  bool until_collapse;    /* end as soon as the block is sure to be in motion for good */
  tp_history *history;    /* NULL: none is kept */
  /* Asked now and then, some 100 times a second at most: true ends the run, as TP_RUN_UNDECIDED
   * with what is known by then. NULL: nothing does. */
  bool (*stop)(void *context);
  void *context;
  /* More steps end the run, as TP_RUN_UNDECIDED with a message; 0: the engine's own bound. */
  double most_steps;
  tp_turn_range *turns; /* NULL: not asked for */
  double *steps;        /* that were made, told at its end; NULL: not asked for */
} tp_run;

#endif
