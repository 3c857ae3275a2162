/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does an inequality in the tilt keep all of some spans, or none? By doubles with bounds, which
 * spares most of them their zeros. */

#ifndef TP_MOTION_TILT_SIDE_H
#define TP_MOTION_TILT_SIDE_H

#include "motion/tilts.h"

/* TP_YES: f is above zero on all of the spans, their ends included; TP_NO: it is below on all; else
 * TP_OPEN. */
tp_answer tp_tilts_side(const tp_motion_tilts *spans, const tp_trig *f);

#endif
