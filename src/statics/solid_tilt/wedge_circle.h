/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least factor of a wedge over all azimuths of a horizontal force, and the least force of all
 * azimuths under which it does not stand (wedge_law.h). Searched in samples and by golden section;
 * certified by arcs on which strength less the factor times what drives it is above zero on every
 * way that may be gone there:
 *     m(z) >= m(z_0) - r max |m'|  on the arc z_0 - r to z_0 + r,
 * halved until that tells. What a search missed is met there, and searched from. */

#ifndef TP_SOLID_TILT_WEDGE_CIRCLE_H
#define TP_SOLID_TILT_WEDGE_CIRCLE_H

#include "solid_tilt/wedge_law.h"

typedef struct tp_wedge_least {
  bool found;
  tp_bounded least;  /* of all azimuths, proven from both sides */
  double half_turns; /* the azimuth at which it was found */
  tp_wedge_way way;  /* which it goes there */
} tp_wedge_least;

/* The factor under a force of t weights, t != 0. Not found: nothing drives it. */
void tp_wedge_least_factor(tp_wedge_least *least, const tp_wedge_law *law, const fmpq_t t);

/* The least force, in weights. Not found: it does not stand without, or this is not certain. */
void tp_wedge_least_reach(tp_wedge_least *least, const tp_wedge_law *law);

#endif
