/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rows of a study as HDF5, made of its rows in CSV, which are what a run goes on from: a data
 * set for each column, chunked and deflated, with its unit; the program's version and the texts of
 * all files that the study rests on as attributes. In a library of its own, which alone needs HDF5;
 * the library loads it where such a file is asked for (study/hdf5_rows.h). */

#ifndef TP_HDF5_HDF5_H
#define TP_HDF5_HDF5_H

#include "study/hdf5_rows.h"

/* The calls that study/hdf5_rows.h says. */
TP_MUST_USE tp_hdf5_check_function tp_hdf5_check;
TP_MUST_USE tp_hdf5_write_function tp_hdf5_write;

#endif
