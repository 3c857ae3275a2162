/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which contact forces hold a solid, and which motion nothing resists: the search, in doubles.
 *
 * The cones of friction are taken for the hull of some of their forces, so that all is a linear
 * program of six rows; its dual is a twist. The force that the twist does most against is added to
 * each cone that has one outside of the hull, until none has: column generation for a cone of
 * second order, which ends after some ten rounds, for the error of the hull is quadratic in the
 * distance of its forces. Nothing here is certain; hold_proof.h judges it. */

#ifndef TP_SOLID_CONTACTS_HOLD_SEARCH_H
#define TP_SOLID_CONTACTS_HOLD_SEARCH_H

#include "solid_contacts/friction_cones.h"

typedef struct tp_cone_force {
  long cone;
  double force[3], column[TP_WRENCH];
} tp_cone_force;

typedef struct tp_hold_search {
  const tp_friction_cones *cones;
  double friction; /* share of every mu */
  long count, room;
  tp_cone_force *forces; /* what the cones are taken for */
} tp_hold_search;

typedef enum tp_hold_aim {
  TP_HOLD_DEEPEST,  /* most t <= 1 with the normal force t at each contact beside what is chosen */
  TP_HOLD_FARTHEST, /* most t with t times `way` beside the load */
  TP_HOLD_APART     /* a twist that does work of one or more on every force: no load */
} tp_hold_aim;

typedef enum tp_hold_outcome {
  TP_HOLD_FOUND,
  TP_HOLD_NONE,    /* no forces hold the load: the twist gains on it */
  TP_HOLD_ENDLESS, /* t has no limit */
  TP_HOLD_STUCK    /* rounding goes in circles */
} tp_hold_outcome;

typedef struct tp_hold_answer {
  tp_hold_outcome outcome;
  double t;
  double twist[TP_WRENCH];
  double (*forces)[3]; /* of each cone: room of the caller's, or NULL */
} tp_hold_answer;

/* With some forces for each cone, turned about its normal by `turn` radians; to be cleared also
 * where it is false: memory is exhausted. */
TP_MUST_USE bool tp_hold_search_init(tp_hold_search *search, const tp_friction_cones *cones,
                                     double friction, double turn);
void tp_hold_search_clear(tp_hold_search *search);

/* Forces with sum + load (+ t way) = 0; both act at the centroid. False when memory is exhausted.
 */
TP_MUST_USE bool tp_hold_find(tp_hold_answer *answer, tp_hold_search *search, tp_hold_aim aim,
                              const double load[3], const double way[3]);

#endif
