/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The normal stress on a facet of a joint between rigid rocks: springs along it that do not pull.
 *
 * The closure is linear along the facet, from `from` at one end to `to` at the other, and the
 * stress is the closure (in units in which k_n is 1) where that is above 0. Forces and stiffnesses
 * are integrals over the closed part, exact; the forces are smooth in the closures (their
 * derivatives have no jump), so that a facet opens bit by bit. A contact in a point has one spring,
 * at `from`. */

#ifndef TP_QUASI_STATIC_FACET_STRESS_H
#define TP_QUASI_STATIC_FACET_STRESS_H

#include <stdbool.h>

typedef struct tp_facet_stress {
  double force_from, force_to; /* at the two ends, of the same force and moment as the stress */
  /* Their derivatives: of either by its own closure, and by that of the other end. */
  double stiffness_from, stiffness_between, stiffness_to;
  double closed;                       /* the share of the length that is closed, 0 to 1 */
  double closed_by_from, closed_by_to; /* its derivatives by the closures */
} tp_facet_stress;

tp_facet_stress tp_facet_stress_of(double length, bool in_a_point, double from, double to);

#endif
