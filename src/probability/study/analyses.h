/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a study may ask for besides its samples: Sobol' indices, reliability of first order, and
 * design values. They solve the scene at points of their own, and keep no rows; what they find is
 * the same by any number of threads. */

#ifndef TP_STUDY_ANALYSES_H
#define TP_STUDY_ANALYSES_H

#include "study/values.h"

/* The keys sensitivity and reliability, and design_values, of a study of which all else is read. */
TP_MUST_USE tp_status tp_study_read_analyses(const tp_study_reader *reader, const tp_node *root);
TP_MUST_USE tp_status tp_study_read_designs(const tp_study_reader *reader, const tp_node *root);

/* A quantity by its name. */
TP_MUST_USE tp_status tp_study_read_quantity(const tp_study_reader *reader,
                                             tp_study_quantity *quantity, const tp_node *node);

/* Into a result that has its variables and columns. `*stopped` where options.stop said so: then
 * nothing is known.
 */
TP_MUST_USE tp_status tp_study_sense(tp_study_result *result, const tp_study *study,
                                     const tp_study_options *options, bool *stopped,
                                     tp_message *message);
TP_MUST_USE tp_status tp_study_rely(tp_study_result *result, const tp_study *study,
                                    const tp_study_options *options, bool *stopped,
                                    tp_message *message);
void tp_study_reliability_clear(tp_study_reliability *reliability);
TP_MUST_USE tp_status tp_study_design_values(tp_study_result *result, const tp_study *study,
                                             const tp_study_options *options, bool *stopped,
                                             tp_message *message);

#endif
