/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mean normal stress that friction by Barton's law is asked at: is it one for which the law
 * holds? */

#ifndef TP_EVALUATION_NORMAL_STRESS_H
#define TP_EVALUATION_NORMAL_STRESS_H

#include "problem/problem.h"

/* Caution where the stress exceeds JCS on level ground or at the scene's tilt, and where the width
 * that is stated is more than touches. */
TP_MUST_USE tp_status tp_normal_stress_cautions(tp_notes *notes, const tp_problem *problem,
                                                tp_message *message);

#endif
