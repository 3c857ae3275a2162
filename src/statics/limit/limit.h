/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit: the tilt beyond which no forces of the base hold the block (docs/mechanics.md
 * section 6), by one linear program where the loads turn with the tilt as the weight does, and by a
 * search in the tilt where some of them do not. */

#ifndef TP_LIMIT_LIMIT_H
#define TP_LIMIT_LIMIT_H

#include "certificate/answer.h"
#include "topple.h"

TP_MUST_USE tp_limit_outcome tp_limit_find(tp_limit_answer *answer,
                                           const tp_limit_question *question);

#endif
