/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One sample: the scene with its numbers, each the decimal that a row shows, solved as `topple
 * solve` does; at further tilts by the same solve, or, where that does not tell, by their own. */

#ifndef TP_STUDY_SAMPLE_H
#define TP_STUDY_SAMPLE_H

#include "study/row.h"

/* Fill in what became of a row that has its values, at the scene's tilt and the first so many of
 * the study's. A scene that cannot be had or solved makes an invalid row, not a failure; what fails
 * otherwise does. */
TP_MUST_USE tp_status tp_study_solve(tp_study_row *row, const tp_study *study, size_t tilts,
                                     tp_message *message);

/* The same of the scene with one number alone in the place of its own, at its tilt. */
TP_MUST_USE tp_status tp_study_solve_with(tp_study_row *row, const tp_study *study,
                                          const tp_scene_key *key, double value,
                                          tp_message *message);

#endif
