/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is told of a block that was solved, and which of two is worse. */

#ifndef TP_SURVEY_JUDGE_H
#define TP_SURVEY_JUDGE_H

#include "output/text.h"
#include "stability/severity.h"
#include "topple_batch.h"
#include "topple_solve.h"

/* Bad input where the scene gives no tilt, or no friction: nothing is said of whether it stands.
 * The message has no place. */
TP_MUST_USE tp_status tp_batch_judge(tp_batch_row *row, const tp_solution *solution,
                                     tp_message *message);

/* Solve the scene and judge the row by it; of a scene with load cases by the one of that name, or
 * where that is NULL by the one that governs. `failed` is set to the name of the case, of several,
 * that the message is of. */
enum { TP_FAILED_CASE = 64 };
TP_MUST_USE tp_status tp_batch_solve_scene(tp_batch_row *row, tp_scene *scene,
                                           const char *load_case, char failed[TP_FAILED_CASE],
                                           const tp_solve_options *options, tp_message *message);

void tp_batch_row_clear(tp_batch_row *row);

/* The proven bounds of an undecided factor in words, rounded outwards, behind what there is;
 * nothing where nothing is proven. */
void tp_batch_add_bounds(tp_text *text, const tp_batch_row *row);

/* By standing, by the factor over that required, of an undecided one by its upper bound and then by
 * its lower one, by name, by line: below 0 where `one` is worse. */
int tp_batch_compare(const void *one, const void *other);

#endif
