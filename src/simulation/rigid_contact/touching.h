/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contacts where block and base touch at one moment, and the laws that hold there: for
 * accelerations, for the speeds after an impact. */

#ifndef TP_RIGID_CONTACT_TOUCHING_H
#define TP_RIGID_CONTACT_TOUCHING_H

#include "rigid_contact/smooth.h"

/* What a contact does. */
typedef enum tp_contact_phase { TP_PHASE_OPEN, TP_PHASE_STICKS, TP_PHASE_SLIPS } tp_contact_phase;

typedef struct tp_touching_contact {
  tp_gap_pair pair;
  tp_gap gap;
  double friction;
  long facet;
  double approach, slip; /* speeds: below 0 it closes; along the tangent */
} tp_touching_contact;

typedef struct tp_touching {
  long count, room;
  tp_touching_contact *items;
  tp_law_contact *law; /* by contact; of those that are closed in a law: */
  long *of_law;        /* which they are */
  long law_count;
  long *can_stay;      /* those of a law at rest that can stay closed (rest.h); */
  long can_stay_count; /* -1: not asked yet */
} tp_touching;

void tp_touching_clear(tp_touching *touching);

/* All of a state, those that are alike once; the pairs of the system are marked as touching or not.
 * False when memory is exhausted. */
TP_MUST_USE bool tp_touching_collect(tp_touching *touching, tp_contact_system *system,
                                     const tp_motion_state *state);

/* Pairs that touched and have opened since touch no more: they close anew at a gap of zero. */
void tp_touching_open(tp_contact_system *system, const tp_motion_state *state);

/* Does one of them close with a speed? */
bool tp_touching_closes(const tp_touching *touching);

/* The law of the accelerations at a time: of contacts that neither close nor open with a speed. */
tp_law tp_touching_accelerations(tp_touching *touching, const tp_contact_system *system,
                                 double time);

/* The law of the speeds after an impact: across of each, at least -restitution times what it was.
 */
tp_law tp_touching_impact(tp_touching *touching, const tp_contact_system *system,
                          const tp_motion_state *state, double restitution);

/* The smooth motion that a solution of the accelerations begins. */
void tp_touching_set_smooth(tp_smooth *smooth, const tp_touching *touching, const tp_law *law,
                            const tp_law_solution *solution);

#endif
