/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The limit where the loads do not all turn with the tilt, or cohesion and bonds hold: the first
 * tilt from level at which nothing holds the block, found in doubles (search.h) or where those are
 * too short at full precision, proven by its mechanism (prove.h) or between two tilts (bracket.h),
 * and as the first by what holds before it (certify.h). */

#ifndef TP_LIMIT_NEAR_H
#define TP_LIMIT_NEAR_H

#include "certificate/answer.h"
#include "linear_program/scaled.h"

tp_limit_outcome tp_near_find(tp_limit_answer *answer, const tp_limit_question *question,
                              tp_scaled *scaled);

#endif
