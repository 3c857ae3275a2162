/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a study is drawn, as its file says it: method, seed, samples and correlations. */

#ifndef TP_STUDY_PLAN_H
#define TP_STUDY_PLAN_H

#include "study/values.h"

/* Of a study of which it is known what varies. */
TP_MUST_USE tp_status tp_study_read_plan(const tp_study_reader *reader, const tp_node *root);

#endif
