/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of the onset on driving loads (docs/mechanics.md, "Factor of safety"). */

#ifndef TP_ONSET_ONSET_DRIVING_H
#define TP_ONSET_ONSET_DRIVING_H

#include "onset/onset_question.h"
#include "onset/onset_result.h"

/* Fills in that of the case at a tilt in degrees; the windows of `telling` are those with the
 * friction there, and `moves` says whether one of them holds the tilt. What is open is undecided.
 */
TP_MUST_USE tp_motion_outcome tp_onset_driving(const tp_onset_telling *telling,
                                               tp_onset_asked *asked, const arb_t tilt,
                                               tp_answer moves);

#endif
