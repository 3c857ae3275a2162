/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the bolts and the pressures of supports of a scene come to. */

#ifndef TP_STABILITY_SUPPORTS_H
#define TP_STABILITY_SUPPORTS_H

#include "problem/problem.h"

/* Into the solution: nothing where the scene has none, or anchors alone that have no more than a
 * direction and a force. */
TP_MUST_USE tp_status tp_describe_supports(tp_solution *solution, const tp_problem *problem,
                                           tp_message *message);

#endif
