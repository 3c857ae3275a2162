/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which horizontal accelerations move a solid at its tilt (stance.h has the formulas). */

#ifndef TP_SOLID_TILT_SHAKEN_H
#define TP_SOLID_TILT_SHAKEN_H

#include "solid_tilt/stance_parts.h"

/* The least of all azimuths, and those of the rose, where it stands under its weight alone. */
void tp_stance_shake(tp_solid_band *band, const tp_stance *x);

#endif
