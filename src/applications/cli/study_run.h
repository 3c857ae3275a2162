/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple study as it runs: one process, or the ranks of mpirun. */

#ifndef TP_CLI_STUDY_RUN_H
#define TP_CLI_STUDY_RUN_H

#include "cli/ranks.h"

/* Is a file of rows HDF5, by the ending of its name? NULL is none. */
bool tp_cli_is_hdf5(const char *rows);

/* Samples, by one process: interrupted by a signal, with its progress on a terminal. */
TP_MUST_USE tp_status tp_cli_study_run(tp_study_result **result, const tp_study *study,
                                       const tp_study_options *options, tp_message *message);

/* The same by all ranks. `*result` is NULL where this rank has nothing to tell, as every one but
 * the first. Of those that fail one has the status, so that it is told once. */
TP_MUST_USE tp_status tp_cli_study_by_ranks(tp_study_result **result, const tp_ranks *ranks,
                                            const char *path, const tp_study_options *options,
                                            tp_message *message);

#endif
