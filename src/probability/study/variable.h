/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a number of the scene varies over, as the study file says it: one of a list, a grid, a
 * column, or a distribution, which may be truncated. */

#ifndef TP_STUDY_VARIABLE_H
#define TP_STUDY_VARIABLE_H

#include "study/values.h"

/* Of a child of the map `vary`. `variable` is all zero before; tp_variable_clear on failure too. */
TP_MUST_USE tp_status tp_variable_read(const tp_study_reader *reader, tp_variable *variable,
                                       const tp_node *node);
void tp_variable_clear(tp_variable *variable);

#endif
