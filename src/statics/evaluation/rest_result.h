/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers of a block that was set down, as results. */

#ifndef TP_EVALUATION_REST_RESULT_H
#define TP_EVALUATION_REST_RESULT_H

#include "problem/rested.h"

/* Where it came to rest. */
tp_rest_result tp_rest_result_of(const tp_rested *rested);

/* By what it has turned in all. */
tp_bounded tp_rest_turned_deg(const tp_rested *rested);

/* A length of its scene in metres. */
tp_bounded tp_rest_metres(const tp_rested *rested, const fmpq_t length);

#endif
