/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One step of a smooth differential equation, by extrapolation of the modified midpoint rule
 * (Gragg, SIAM J. Numer. Anal. 2 (1965); Hairer, Norsett and Wanner, Solving Ordinary Differential
 * Equations I, section II.9): of 2, 4, 6, ... substeps, until two columns of the table agree within
 * the tolerance.
 *
 * The steppers of the GNU Scientific Library, which the tests compare it with, ask for memory and
 * end the process where there is none (docs/architecture.md: the library never does); this one
 * needs none, and takes the order that the tolerance asks for. */

#ifndef TP_RIGID_CONTACT_EXTRAPOLATION_H
#define TP_RIGID_CONTACT_EXTRAPOLATION_H

#include <stdbool.h>

/* Place and speed of a plane body, and the work done on it. */
enum { TP_MOTION_NUMBERS = 7 };

/* Rates at a time; false where there are none. */
typedef bool (*tp_rates)(double *rates, void *context, double time, const double *state);

typedef struct tp_step_answer {
  bool reached; /* within the tolerance, of which the error is a share */
  double error;
  int columns; /* that it took: the fewer the longer a step may be */
} tp_step_answer;

/* The state a step later; the tolerance is of every number. `next` may be `state`. */
tp_step_answer tp_extrapolate(double next[TP_MOTION_NUMBERS], tp_rates rates, void *context,
                              double time, const double state[TP_MOTION_NUMBERS], double step,
                              double tolerance);

#endif
