/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many pieces joints will make, before any is cut. */

#ifndef TP_JOINTING_JOINT_COUNT_H
#define TP_JOINTING_JOINT_COUNT_H

#include "jointing/cuts.h"

/* Of the section, whose outline is known: no more than a hundred thousand, about? */
TP_MUST_USE tp_status tp_joints_check_count(tp_cuts *cuts, tp_message *message);

#endif
