/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A column of a CSV file, by the name that its first line gives it: FILE.csv:name. Fields are
 * separated and quoted as in files of points (format/csv_row.h); every row has a number there. */

#ifndef TP_STUDY_COLUMN_H
#define TP_STUDY_COLUMN_H

#include "study/values.h"

/* Into the values of the variable, which it owns also on failure. The file goes into the study's
 * hash. */
TP_MUST_USE tp_status tp_study_read_column(const tp_study_reader *reader, tp_variable *variable,
                                           const tp_node *node);

#endif
