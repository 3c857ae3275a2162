/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Up to which horizontal force a wedge stands towards an azimuth (wedge_law.h). */

#ifndef TP_SOLID_TILT_WEDGE_REACH_H
#define TP_SOLID_TILT_WEDGE_REACH_H

#include "solid_tilt/wedge_law.h"

/* The least t above 0 at which it does not stand towards a direction, and which way it goes then;
 * false: it does not stand without, or this is not certain. */
bool tp_wedge_reach(arb_t reach, tp_wedge_way *way, const tp_wedge_law *law, const arb_t east,
                    const arb_t north);

#endif
