/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rows of a study as HDF5, made of its rows in CSV, which are what a run goes on from: a data
 * set for each column, chunked and deflated, with its unit; the program's version and the texts of
 * all files that the study rests on as attributes. In a library of its own, which alone needs HDF5;
 * the library loads it where such a file is asked for (study/hdf5_rows.h). */

#ifndef TP_HDF5_HDF5_H
#define TP_HDF5_HDF5_H

#include "topple_study.h"

/* Asked now and then: true ends the work, and no file is made. */
typedef bool tp_hdf5_stop(void *context);

/* Before a study is run, so that hours are not in vain: may the file `path` be made, or replaced?
 * Bad input where it is one that the study reads, no regular file, or one of somebody else: there,
 * with no progress beside `csv`, and not to be begun anew. */
TP_MUST_USE tp_status tp_hdf5_check(const char *path, const tp_study *study, const char *csv,
                                    bool restart, tp_message *message);

/* Make the file of all rows in `csv`, whole or not at all. The same rows give the same bytes. */
TP_MUST_USE tp_status tp_hdf5_write(const char *path, const tp_study *study, const char *csv,
                                    tp_hdf5_stop *stop, void *context, tp_message *message);

#endif
