/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a row has of a scene of a solid that was solved: of the band that governs. */

#ifndef TP_STUDY_SOLID_SAMPLE_H
#define TP_STUDY_SOLID_SAMPLE_H

#include "solid_tilt/solve_solid.h"
#include "study/row.h"

/* At the scene's own tilt (`at` 0) all of it, at a further one what becomes of it there. */
void tp_study_take_solid(tp_study_row *row, size_t at, const tp_solid *solid);

#endif
