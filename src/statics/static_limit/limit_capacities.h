/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cohesion and bonds of the contact that the scene has, as capacities of its cones. */

#ifndef TP_STATIC_LIMIT_LIMIT_CAPACITIES_H
#define TP_STATIC_LIMIT_LIMIT_CAPACITIES_H

#include "evaluation/evaluation.h"
#include "linear_program/cones.h"

/* False when memory is exhausted. */
TP_MUST_USE bool tp_limit_capacities_add(tp_cones *cones, const tp_evaluation *evaluation);

#endif
