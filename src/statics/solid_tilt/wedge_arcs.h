/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does a wedge stand with a factor for all azimuths of a horizontal force (wedge_circle.h)? */

#ifndef TP_SOLID_TILT_WEDGE_ARCS_H
#define TP_SOLID_TILT_WEDGE_ARCS_H

#include "solid_tilt/wedge_law.h"

typedef enum tp_wedge_round { TP_WEDGE_HOLDS, TP_WEDGE_FAILS, TP_WEDGE_OPEN } tp_wedge_round;

/* With a force of t weights and a factor above 0. Fails: at this azimuth, in half turns. */
tp_wedge_round tp_wedge_arcs(double *half_turns, const tp_wedge_law *law, const arb_t t,
                             const arb_t factor);

#endif
