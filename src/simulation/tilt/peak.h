/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How near a rocking block came to overturning. */

#ifndef TP_TILT_PEAK_H
#define TP_TILT_PEAK_H

#include "tilt/tilting.h"

/* Into the case: the peak of its turn, and as a share of the turn to its balance. The table is at
 * `angle` in radians. */
void tp_tilting_peak(tp_tilting *tilting, const tp_turn_range *turns, double angle);

#endif
