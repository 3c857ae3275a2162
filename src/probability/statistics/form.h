/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The first-order reliability method: the design point z*, of those with g = 0 the nearest to the
 * origin, its distance the reliability index beta (Hasofer and Lind, J. Engineering Mechanics
 * Division ASCE 100 (1974) 111-121), and Phi(-beta), which is the probability of failure where g is
 * linear.
 *
 * Steps of Rackwitz and Fiessler (Computers and Structures 9 (1978) 489-494) by central
 * differences, halved until |z|^2 / 2 + c |g| falls enough, with which they converge where g is
 * smooth (Zhang and Der Kiureghian, Proc. 6th IFIP WG 7.5 (1994) 297-304). They find one point, of
 * the least distance nearby or by symmetry a saddle: the others are found by design_points.h. */

#ifndef TP_STATISTICS_FORM_H
#define TP_STATISTICS_FORM_H

#include "statistics/reliability.h"

/* How the search ended: but for the first, what it found is where it stopped. */
typedef enum tp_form_state {
  TP_FORM_CONVERGED,
  TP_FORM_FLAT,      /* g does not change near the point */
  TP_FORM_STUCK,     /* no step, however short, comes nearer: g leaps or bends sharply */
  TP_FORM_STEPS,     /* more steps than allowed */
  TP_FORM_UNDECIDED, /* g is undecided near the point */
  TP_FORM_FAR        /* beyond 37 deviations, where probabilities are no doubles any more */
} tp_form_state;

/* What that means and what to do, as a sentence without its full stop. */
const char *tp_form_state_text(tp_form_state state);

/* What is added to g so that a search goes elsewhere: height (radius^2 - |z - centre|^2)^2 within
 * the radius, 0 beyond (Der Kiureghian and Dakessian, Structural Safety 20 (1998) 37-49). */
typedef struct tp_form_bulge {
  const double *centre;
  double radius, height;
} tp_form_bulge;

typedef struct tp_form_options {
  double step;      /* of the differences, in deviations */
  double tolerance; /* of beta; z* is found to 100 times as much, which beta does not feel */
  int most_steps;
  const double *start; /* scores where the search begins; NULL: the origin */
  size_t bulge_count;
  const tp_form_bulge *bulges;
} tp_form_options;

/* 1e-3, 1e-6, 100, from the origin, no bulges: for a g that scatters by less than some 1e-8 of what
 * a deviation changes it by.
 */
tp_form_options tp_form_options_default(void);

typedef struct tp_form {
  tp_form_state state;
  double beta; /* below 0 where the means fail */
  double probability;
  uint64_t calls; /* points at which g was asked */
  int steps;
  double slope; /* of g at z*, its bulges included */
  size_t dimensions;
  double *scores;     /* z* */
  double *point;      /* x*, of the variables */
  double *importance; /* their shares of the variance of g made linear, each taken as if
                         independent: they add up to 1 */
} tp_form;

/* A search that does not converge is TP_OK, and its state says so. */
tp_status tp_form_find(tp_form *form, const tp_reliability *problem, const tp_form_options *options,
                       tp_message *message) TP_MUST_USE;

void tp_form_clear(tp_form *form);

#endif
