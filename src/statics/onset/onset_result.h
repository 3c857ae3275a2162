/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proven windows of motion in the words of the field. */

#ifndef TP_ONSET_ONSET_RESULT_H
#define TP_ONSET_ONSET_RESULT_H

#include "evaluation/certainty.h"
#include "motion/windows.h"

/* What a result is made from. */
typedef struct tp_onset_telling {
  const tp_evaluation *e;
  tp_certainty *certainty;
  tp_case *result;
  const tp_motion_question *question;
  const tp_motions *motions;
  const tp_motion_windows *windows;
} tp_onset_telling;

/* The window that the onset is the lower end of: the one that holds level ground, or else the first
 * above it. */
enum { TP_NO_WINDOW = -1, TP_WINDOW_OPEN = -2 };
long tp_onset_first_window(const tp_motion_windows *windows, const tp_judge *judge);

/* Fills in all but the motions at the scene's tilt, with the first window. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_onset_describe(const tp_onset_telling *telling, long first);

/* The centre of a rotation, (-v_y, v_x) / theta, in metres of the scene. */
void tp_onset_centre(tp_bounded *x_m, tp_bounded *y_m, const tp_onset_telling *telling,
                     const tp_vector *twist);

#endif
