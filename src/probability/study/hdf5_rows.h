/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows as HDF5: a run writes and goes on from CSV beside the file, and once the study is whole, the
 * file is made of that by libtopple-hdf5 (applications/hdf5), which alone needs HDF5 and is loaded
 * where such a file is asked for. */

#ifndef TP_STUDY_HDF5_ROWS_H
#define TP_STUDY_HDF5_ROWS_H

#include "study/study.h"

/* Asked now and then: true ends the work, and no file is made. */
typedef bool tp_hdf5_stop(void *context);

/* Before a study is run, so that hours are not in vain: may the file `path` be made, or replaced?
 * Bad input where it is one that the study reads, no regular file, or one of somebody else: there,
 * with no progress beside `csv`, and not to be begun anew. */
typedef tp_status tp_hdf5_check_function(const char *path, const tp_study *study, const char *csv,
                                         bool restart, tp_message *message);

/* Make the file of all rows in `csv`, whole or not at all. The same rows give the same bytes. By
 * ranks all call it: each reads and deflates its share of the rows, and the first writes. */
typedef tp_status tp_hdf5_write_function(const char *path, const tp_study *study, const char *csv,
                                         const tp_study_ranks *ranks, tp_hdf5_stop *stop,
                                         void *context, tp_message *message);

typedef struct tp_hdf5_rows {
  const char *path; /* NULL: none are asked for */
  char *csv;        /* beside it; owned */
  tp_hdf5_check_function *check;
  tp_hdf5_write_function *write;
} tp_hdf5_rows;

/* By the ending of options.rows, which is the CSV from then on. Before the study is run: can the
 * file be made? By ranks the first one looks at what is there. To be ended on failure, too. */
TP_MUST_USE tp_status tp_hdf5_rows_begin(tp_hdf5_rows *own, tp_study_options *options,
                                         const tp_study *study, tp_message *message);
/* Made, of a study that is whole; where options.stop ends that, the result is interrupted. By ranks
 * all call it, the first with the result. */
TP_MUST_USE tp_status tp_hdf5_rows_make(const tp_hdf5_rows *own, tp_study_result *result,
                                        const tp_study *study, const tp_study_options *options,
                                        tp_message *message);
void tp_hdf5_rows_end(tp_hdf5_rows *own);

#endif
