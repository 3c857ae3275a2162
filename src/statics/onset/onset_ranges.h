/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which motions can begin at every tilt: where one takes over from another. */

#ifndef TP_ONSET_ONSET_RANGES_H
#define TP_ONSET_ONSET_RANGES_H

#include "onset/onset_result.h"

/* Fills in the ranges of the case's onset. On failure there are none. */
TP_MUST_USE tp_motion_outcome tp_onset_ranges(const tp_onset_telling *telling);

#endif
