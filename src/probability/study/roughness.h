/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How rough the base of each sample is, where the study asks: numbers of roughness
 * (docs/profile.md), and between which angles Eqs. (15) and (16) put an upright block on it. */

#ifndef TP_STUDY_ROUGHNESS_H
#define TP_STUDY_ROUGHNESS_H

#include "study/row.h"
#include "study/values.h"

/* As the study file and the rows call it, these with the unit of the scene's lengths; and the unit,
 * NULL where it has none. */
const char *tp_study_measure_name(tp_study_measure_kind kind);
bool tp_study_measure_is_length(tp_study_measure_kind kind);
const char *tp_study_measure_unit(const tp_study *study, size_t measure);

/* The key roughness. */
TP_MUST_USE tp_status tp_study_read_roughness(const tp_study_reader *reader, const tp_node *root);

/* Into a row that was solved. What cannot be measured has no number. */
TP_MUST_USE tp_status tp_study_measure_roughness(tp_study_row *row, const tp_study *study,
                                                 tp_message *message);

#endif
