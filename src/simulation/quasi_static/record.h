/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* States of a path written into a history: events between two of them, moments, reactions. */

#ifndef TP_QUASI_STATIC_RECORD_H
#define TP_QUASI_STATIC_RECORD_H

#include "quasi_static/state.h"

/* Is there an event between the two? */
bool tp_path_states_differ(const tp_path_state *before, const tp_path_state *after,
                           const tp_path_model *model);

/* The events that lead from one to the other, at the tilt of the second; `before` NULL: from all
 * ends closed, and nothing slipping. `count` is raised by their number. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_path_record_events(tp_history *history, long *count,
                                       const tp_path_state *before, const tp_path_state *after,
                                       const tp_path_model *model);

/* A moment, with the reaction on each facet of the base. */
TP_MUST_USE bool tp_path_record_moment(tp_history *history, const tp_path_state *state,
                                       const tp_path_model *model);

/* The collapse of the block at a tilt. */
TP_MUST_USE bool tp_path_record_collapse(tp_history *history, double tilt,
                                         const tp_path_model *model);

#endif
