/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of a contact with many facets that a plan leaves out: no motion that the others allow
 * closes them, so that they matter to none. That is proven of each motion by itself. */

#ifndef TP_CASE_FILTER_CONTACT_REST_H
#define TP_CASE_FILTER_CONTACT_REST_H

#include "number/near.h"

enum { TP_REST_FACETS = 96, TP_REST_POINTS = 2 * TP_REST_FACETS };

/* From the centroid, and along their facets, each rounded but for that once; the centroid, and what
 * positions are measured from, is known to within `off`, and no point lies farther from it than
 * `far` along either axis. */
typedef struct tp_contact_rest {
  int count;
  double x[TP_REST_POINTS], y[TP_REST_POINTS], tx[TP_REST_POINTS], ty[TP_REST_POINTS];
  double far, off;
} tp_contact_rest;

/* Does every point open as the block moves by the twist, for certain? */
bool tp_contact_rest_opens(const tp_contact_rest *rest, const tp_near twist[3]);

/* Does no force within the friction cone of any point resist it? */
bool tp_contact_rest_yields(const tp_contact_rest *rest, const tp_near twist[3], tp_near friction);

#endif
