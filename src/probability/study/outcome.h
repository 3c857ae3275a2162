/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What becomes of a sample, by the mechanism of its block. */

#ifndef TP_STUDY_OUTCOME_H
#define TP_STUDY_OUTCOME_H

#include "topple_study.h"

/* A mechanism without an outcome of its own is undecided. */
tp_study_outcome tp_study_outcome_of(tp_mechanism mechanism);

#endif
