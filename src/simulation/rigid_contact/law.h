/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Newton's law with contacts that open or press, and Coulomb friction: the modes of
 * docs/mechanics.md section 6a in doubles, with given velocities too. Asked for is x
 * (accelerations, or velocities after an impact) with
 *
 *   M x = M x_free + sum lambda e,   lambda >= 0,   across . x >= least at every contact,
 *
 * e = n - t tan(phi) where a contact slips along t, n + t tan(phi) where it slips against it, both
 * edges where it sticks; no force where across . x > least, and along . x - rest of the sign of the
 * slip, 0 where it sticks.
 *
 * Every solution is a sum of such with three edges or fewer whose wrenches are independent
 * (Caratheodory). So each set of up to three edges is tried: as many equations, across . x = least
 * of its contacts and along . x = rest of one with both edges, give its multipliers; then the signs
 * are judged. A set whose equations depend on each other has no solution of its own. */

#ifndef TP_RIGID_CONTACT_LAW_H
#define TP_RIGID_CONTACT_LAW_H

#include "plane/contact_rows.h"

enum { TP_LAW_EDGES = 3 };

typedef struct tp_law_contact {
  double across[3], along[3];
  double least, rest;
  double friction; /* tan(phi) */
  int slip;        /* it slips along t: 1, against it: -1, as given; 0: still open */
} tp_law_contact;

typedef struct tp_law {
  double inertia[3]; /* the diagonal of M */
  double free[3];
  long count;
  const tp_law_contact *contacts;
} tp_law;

/* An edge of a friction cone: n + side t tan(phi). */
typedef struct tp_law_edge {
  long contact;
  int side;
} tp_law_edge;

typedef struct tp_law_solution {
  int count;
  tp_law_edge edges[TP_LAW_EDGES];
  double factors[TP_LAW_EDGES]; /* lambda */
  double x[3];
  bool paradox; /* Painleve: its one contact that slips would press itself harder */
} tp_law_solution;

/* The multipliers of the edges of `solution`, and x, by their equations alone. False where these
 * depend on each other. */
bool tp_law_solve(tp_law_solution *solution, const tp_law *law);

/* Signs are judged within this share of the numbers they come from. */
extern const double tp_law_tolerance;
double tp_law_slack(const tp_law *law);

/* The contact that a solution violates most, and by more than the slack; -1: none. */
long tp_law_worst(const tp_law_solution *solution, const tp_law *law, double slack);

/* Told of each solution; false ends the search. */
typedef bool (*tp_law_found)(void *context, const tp_law_solution *solution);

/* Those with edges of the contacts listed alone, up to `most` edges. */
void tp_law_enumerate(const tp_law *law, const long *listed, long listed_count, int most,
                      tp_law_found found, void *context);

/* Solutions with edges of as few contacts as serve: the list grows by the contact that those found
 * so far violate most, until one violates none. Told of all that the last list gives. */
void tp_law_search(const tp_law *law, tp_law_found found, void *context);

/* All solutions with edges of the first 24 contacts: more than these do not press on a plane body
 * but for ties. */
void tp_law_search_all(const tp_law *law, tp_law_found found, void *context);

#endif
