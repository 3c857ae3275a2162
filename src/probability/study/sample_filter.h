/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples told by doubles with proven bounds (case_filter/keyed_filter.h). */

#ifndef TP_STUDY_SAMPLE_FILTER_H
#define TP_STUDY_SAMPLE_FILTER_H

#include "case_filter/keyed_filter.h"
#include "study/row.h"

/* `*filter` stays NULL where the study's samples are none for it. */
TP_MUST_USE tp_status tp_sample_filter_new(tp_keyed_filter **filter, const tp_study *study,
                                           tp_message *message);

/* A row that has its values, at the scene's tilt and the first so many of the study's; false where
 * doubles do not tell all of it, or not all digits that a row shows. The row is left alone then. */
TP_MUST_USE bool tp_sample_filter_tell(tp_study_row *row, const tp_study *study, size_t tilts);

#endif
