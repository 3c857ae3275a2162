/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What becomes of a sample, by the mechanism of its block, or by the verdict on its many; and which
 * numbers it has. */

#ifndef TP_STUDY_OUTCOME_H
#define TP_STUDY_OUTCOME_H

#include "study/study.h"

/* A mechanism without an outcome of its own is undecided. */
tp_study_outcome tp_study_outcome_of(tp_mechanism mechanism);

/* Blocks that forces can hold may move: that no motion begins is not known. Those that collapse
 * move as the collapse has it, and where none is known in both ways. */
tp_study_outcome tp_study_outcome_of_system(const tp_system_case *own);

/* Is the scene one of many blocks? */
bool tp_study_is_of_many(const tp_study *study);

/* Is it one of a solid? */
bool tp_study_is_of_solid(const tp_study *study);

/* So many quantities, the first of all, have columns; and has a scene like this one the quantity?
 */
size_t tp_study_quantity_count(const tp_study *study);
bool tp_study_has_quantity(const tp_study *study, tp_study_quantity quantity);

/* Does the scene lie at a tilt, or its many blocks as they lie, so that there is a factor of
 * safety?
 */
bool tp_study_has_stance(const tp_study *study);

/* Factors of safety fail at 1. */
bool tp_study_quantity_is_factor(tp_study_quantity quantity);

#endif
