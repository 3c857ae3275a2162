/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ways in which a block can begin to move at the scene's tilt. */

#ifndef TP_ONSET_ONSET_MOTIONS_H
#define TP_ONSET_ONSET_MOTIONS_H

#include "onset/onset_result.h"

/* Fills in the motions of the case's onset, at a tilt in degrees: none outside all windows, where
 * the block may not move. What is open, or too dear, is left out. */
TP_MUST_USE tp_motion_outcome tp_onset_motions(const tp_onset_telling *telling, const arb_t tilt,
                                               bool may_move);

#endif
