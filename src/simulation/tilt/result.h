/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a test found, as it is told: the history in the scene's frame, the outlines, the summary. */

#ifndef TP_TILT_RESULT_H
#define TP_TILT_RESULT_H

#include "tilt/trial.h"

/* The history becomes the case's. */
void tp_tilt_result_take(tp_tilt_case *own, tp_history *history, const tp_rigid_body *body);

/* The outline and the base, arcs by chords no longer than a fiftieth of the extent; false when
 * memory is exhausted. */
TP_MUST_USE bool tp_tilt_result_draw(tp_tilt_case *own, const tp_rigid_body *body);

/* Where the bracket lies against onset and limit, which are filled in, within the wanted width of
 * the bracket. */
void tp_tilt_result_place(tp_tilt_case *own, double tolerance_deg);

/* From a case of statics; `own` is zero but for what is found elsewhere. */
void tp_tilt_result_window(tp_tilt_case *own, const tp_case *statics);

#endif
