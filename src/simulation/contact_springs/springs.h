/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on contact springs, by explicit steps: the method of the paper's numerical models
 * (section 4.3; distinct elements after Cundall).
 *
 * A rigid block of any outline on a rigid base of any profile. Contacts have a normal spring k_n
 * without tension and a shear spring k_s with Coulomb's limit on the length that each stands for
 * (contacts.h); corners are rounded by a small radius (features.h); central differences with local
 * damping (stepper.h). Before time 0 the block settles on its springs (settlement.h). Whether it
 * collapses is told by its acceleration (watch.h).
 *
 * What it costs: some 0.1 microseconds a step and contact; steps of a fifth of the longest stable
 * one, which goes with sqrt(m / k). The answer depends on stiffness, rounding, damping and step:
 * see docs/tilt_springs.md for how it converges. */

#ifndef TP_CONTACT_SPRINGS_SPRINGS_H
#define TP_CONTACT_SPRINGS_SPRINGS_H

#include "rigid_body/history.h"

typedef struct tp_spring_settings {
  double normal_pa_m; /* k_n, above 0 */
  double shear_pa_m;  /* k_s, above 0 */
  double damping;     /* local: the share of the unbalanced force taken, 0 to below 1 */
  double rounding_m;  /* radius of corners, above 0 and far below the block's extent */
  double time_step_s; /* 0: a fifth of the longest stable one */
} tp_spring_settings;

/* Bad input: a setting out of its range, or a time step above the longest stable one for this body,
 * which the message says. Out of memory cannot happen. `place` is what calls for the springs. */
TP_MUST_USE tp_status tp_springs_check(const tp_spring_settings *settings,
                                       const tp_rigid_body *body, tp_place place,
                                       tp_message *message);

/* Of a run: as given, or a share of that stable one. */
double tp_springs_step(const tp_spring_settings *settings, const tp_rigid_body *body);

/* 2 / omega with all contacts of the start closed, s. */
double tp_springs_stable_step(const tp_spring_settings *settings, const tp_rigid_body *body);

/* `*last` is the state in which it ends. TP_RUN_UNDECIDED with a message where the time step given
 * turns out too long for contacts that close on the way. */
TP_MUST_USE tp_run_end tp_springs_run(tp_body_state *last, const tp_run *run,
                                      const tp_spring_settings *settings, tp_message *message);

#endif
