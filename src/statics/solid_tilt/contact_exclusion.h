/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of a solid on few contact points that forces hold: that no motion at all can begin
 * (solid_contacts/solid_exclusion.h), under its load, and up to which multiples of what drives it
 * and which divisors of strength. */

#ifndef TP_SOLID_TILT_CONTACT_EXCLUSION_H
#define TP_SOLID_TILT_CONTACT_EXCLUSION_H

#include "solid_tilt/contact_work.h"

typedef struct tp_contact_exclusion {
  bool stands;              /* no motion can begin, proven, in three dimensions */
  double driving, strength; /* if stands: up to that much, from 1 on */
} tp_contact_exclusion;

/* What is not proven stays open. The limits of forces are those of the weak side. */
TP_MUST_USE bool tp_contact_exclusion_find(tp_contact_exclusion *exclusion,
                                           const tp_contact_work *work, const tp_weak_side *weak);

/* Up to which t no motion can begin under load + t way, from zero on: zero where nothing is proven.
 * Forces hold no more than `limit`. */
TP_MUST_USE bool tp_contact_exclusion_from(double *reached, const tp_contact_work *work,
                                           const tp_hold_load *load, const tp_hold_load *way,
                                           double limit);

#endif
