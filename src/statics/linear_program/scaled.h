/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cones in doubles, each column scaled to size one, lengths by that of the contact, moments
 * about a point of it: what the simplex method works on. A scaled finds a basis; a face then proves
 * it. */

#ifndef TP_LINEAR_PROGRAM_SCALED_H
#define TP_LINEAR_PROGRAM_SCALED_H

#include "linear_program/cones.h"
#include "linear_program/simplex.h"
#include "number/near.h"
#include "plane/vector.h"

typedef struct tp_scaled tp_scaled;
struct tp_scaled {
  long count;
  double (*columns)[3];
  double *most; /* NULL: none is bounded; in units of `force` */
  bool *at_most;
  long length_exponent, force_exponent; /* units of 2^ */
  arb_t x, y;                           /* what moments are about, exact */
  double error, largest[3];             /* bounds: of the entries' error; of each row's entries */
  long bits;
  bool out_of_memory; /* in a step on it: what was left open is open for want of memory */
};

/* `size` is a wrench of the size of the loads, the weight's say. False when memory is exhausted. */
bool tp_scaled_init(tp_scaled *scaled, const tp_cones *cones, const tp_vector *size, long bits);
void tp_scaled_clear(tp_scaled *scaled);

/* A copy with tan(phi) and all bounds divided: the two edges of a cone, scaled alike, are their
 * mean and plus or minus their half difference over the divisor. */
bool tp_scaled_copy(tp_scaled *copy, const tp_scaled *scaled);
void tp_scaled_divide_strength(tp_scaled *scaled, const tp_scaled *given, long edges,
                               double divisor);

/* A wrench in the scaled program's units; with a bound of each entry's error. */
void tp_scaled_wrench(double wrench[3], const tp_scaled *scaled, const tp_vector *of);
void tp_scaled_wrench_near(tp_near wrench[3], const tp_scaled *scaled, const tp_vector *of);

/* A twist about the point of the scaled program's moments, lengths by its unit; and back. */
void tp_scaled_twist(tp_vector *own, const tp_scaled *scaled, const tp_vector *twist);
void tp_scaled_untwist(tp_vector *twist, const tp_scaled *scaled, const tp_vector *own);

/* Maximise t subject to sum f c + t direction = target. */
tp_simplex_answer tp_scaled_solve(tp_scaled *scaled, const double direction[3],
                                  const double target[3]);

#endif
