/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The result of a study, of its tally and of how it ended. */

#ifndef TP_STUDY_RESULT_H
#define TP_STUDY_RESULT_H

#include "study/tally.h"

/* Of a study that is whole, with the analyses that it asks for besides. */
TP_MUST_USE tp_status tp_study_sum_up(tp_study_result **result, tp_tally *tally, tp_study_end end,
                                      const tp_study_options *options, tp_message *message);

/* A file that no chart of the result may be written over. */
TP_MUST_USE tp_status tp_study_add_source(tp_study_result *result, const char *path,
                                          tp_message *message);

#endif
