/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Motion between two events: the contacts that press keep closed, each sticking or slipping in one
 * sense, and their forces follow from that at every moment (rigid_contact/law.h). */

#ifndef TP_RIGID_CONTACT_SMOOTH_H
#define TP_RIGID_CONTACT_SMOOTH_H

#include "rigid_contact/extrapolation.h"
#include "rigid_contact/law.h"
#include "rigid_contact/system.h"

/* A contact that presses. */
typedef struct tp_pressing {
  tp_gap_pair pair;
  double friction;
  long facet;
  bool sticks; /* by both of its edges; else: */
  int side;    /* of its one edge */
  bool pinned; /* which it needs no slip for: other contacts hold it */
} tp_pressing;

typedef struct tp_smooth {
  const tp_contact_system *system;
  int count;
  tp_pressing pressing[TP_LAW_EDGES];
  long evaluations; /* of its rates */
} tp_smooth;

/* Everything of one moment: the contacts, their forces, the acceleration. */
typedef struct tp_smooth_moment {
  tp_gap gaps[TP_LAW_EDGES];
  tp_law_contact contacts[TP_LAW_EDGES];
  tp_law_solution solution; /* its contacts are numbers of `pressing` */
  double free[3];           /* the acceleration without contacts */
  double friction_power;
} tp_smooth_moment;

/* False where the contacts' equations depend on each other. */
bool tp_smooth_at(tp_smooth_moment *moment, tp_smooth *smooth, double time,
                  const tp_motion_state *state);

/* The state in the numbers of a step: place, speed, work of the loads and of friction. */
tp_motion_state tp_smooth_state(const double numbers[TP_MOTION_NUMBERS]);
void tp_smooth_numbers(double numbers[TP_MOTION_NUMBERS], const tp_motion_state *state,
                       double work);

/* The rates of a step; the context is the tp_smooth. */
bool tp_smooth_rates(double *rates, void *context, double time, const double *numbers);

/* What rounding and the error of a step have moved the contacts that press out of place, or given
 * them as speed, is taken back by the least motion that does; it is what is told, over the extent.
 */
double tp_smooth_project(tp_motion_state *state, const tp_smooth *smooth);

/* The least kinetic energy that takes its speed from each row: speeds that are left are 0. Rows
 * that depend on others are left out. */
void tp_smooth_stop(double speed[3], const tp_contact_system *system, const double (*rows)[3],
                    int count);

#endif
