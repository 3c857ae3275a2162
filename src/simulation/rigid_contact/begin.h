/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* When does a block at rest begin to move? On a table that tilts, under its weight alone, none of
 * its modes is feasible up to a tilt that follows in closed form (rigid_contact/rest.h); from there
 * on, and under loads and shaking, it is looked at from time to time, and the begin is halved down.
 */

#ifndef TP_RIGID_CONTACT_BEGIN_H
#define TP_RIGID_CONTACT_BEGIN_H

#include "rigid_contact/dynamics.h"

/* It has come to rest: finds out until when it is sure to stay so. */
void tp_begin_wait(tp_dynamics *dynamics);

/* The time at which to look next: every 0.05 degrees of the table, every 0.02 of the unit of time
 * of shaking. Where it is sure to rest for longer, later. */
double tp_begin_next_look(const tp_dynamics *dynamics);

/* When, between the time, at which it rests, and a later one, at which it moves, does it begin? The
 * time is then that. */
tp_resolved tp_begin_find(tp_dynamics *dynamics, double moves_at);

/* Sets the mode. Where the acceleration is nothing but rounding it tells none: the mode is that of
 * so much later that it is told, or of the last time tried; how it moves until then is not seen in
 * any number. */
tp_resolved tp_begin_choose(double *later, tp_dynamics *dynamics);

#endif
