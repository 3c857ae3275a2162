/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a row has of a scene of many blocks that was solved: of the direction that governs. */

#ifndef TP_STUDY_SYSTEM_SAMPLE_H
#define TP_STUDY_SYSTEM_SAMPLE_H

#include "study/row.h"

/* At the scene's own tilt (`at` 0) all of it, at a further one what becomes of the blocks there. */
void tp_study_take_system(tp_study_row *row, size_t at, const tp_block_system *system);

#endif
