/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The path from its first tilt to its end, followed step by step with halving at events. */

#ifndef TP_QUASI_STATIC_FOLLOW_H
#define TP_QUASI_STATIC_FOLLOW_H

#include "quasi_static/model.h"

/* Fills in a result that is 0 from its first angle to its end; `history` may be NULL. */
void tp_path_follow(tp_path_result *result, const tp_path_model *model,
                    const tp_path_settings *settings, tp_history *history);

#endif
