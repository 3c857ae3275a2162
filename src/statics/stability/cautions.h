/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cautions on scenes whose problem is computed otherwise than their author may expect. */

#ifndef TP_STABILITY_CAUTIONS_H
#define TP_STABILITY_CAUTIONS_H

#include "stability/problem.h"

TP_MUST_USE tp_status tp_problem_cautions(tp_notes *notes, const tp_problem *problem,
                                          tp_message *message);

#endif
