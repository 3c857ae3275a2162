/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where the rows of topple study go: into CSV, which a run goes on from; and of that, once the
 * study is whole, into HDF5 where the file asked for is one, by a library that is loaded then. */

#ifndef TP_CLI_STUDY_ROWS_H
#define TP_CLI_STUDY_ROWS_H

#include "topple.h"

typedef struct tp_study_file {
  const char *hdf5; /* NULL: none is asked for */
  char *csv;        /* beside it, the rows that it is made of; owned */
} tp_study_file;

/* By the ending of the name. False when memory is exhausted. */
TP_MUST_USE bool tp_cli_study_file_name(tp_study_file *file, const char *path);

/* Can it be made? Asked before the study is run. Nothing where no HDF5 is asked for. */
TP_MUST_USE tp_status tp_cli_study_file_check(const tp_study_file *file, const tp_study *study,
                                              bool restart, tp_message *message);

/* Made, once the study is whole; of one that was interrupted it is told where the rows are. */
TP_MUST_USE tp_status tp_cli_study_file_write(const tp_study_file *file, const tp_study *study,
                                              const tp_study_result *result, tp_message *message);

#endif
