/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A column of the rows as a data set: numbers as doubles (NaN: none), words as texts of fixed
 * length, any text by its length. Rows are gathered in blocks, of which each is a chunk of the
 * file, deflated; so memory does not grow with the rows. */

#ifndef TP_HDF5_COLUMN_H
#define TP_HDF5_COLUMN_H

#include "hdf5/file.h"
#include "output/text.h"
#include "study/field.h"

typedef struct tp_hdf5_column {
  size_t field;
  tp_study_field_kind kind;
  hid_t set, type;
  size_t size; /* of one value in memory */
  char *block;
} tp_hdf5_column;

/* Rows in a block; fewer where there are fewer. */
size_t tp_hdf5_block_rows(uint64_t rows);

/* An empty data set of so many rows, by its name, with its unit. False: HDF5 or memory fails, and
 * what there is must be closed all the same. */
TP_MUST_USE bool tp_hdf5_column_open(tp_hdf5_column *column, hid_t file, const tp_study *study,
                                     size_t field, uint64_t rows);
/* With `filled` rows in its block that were not written. */
void tp_hdf5_column_close(tp_hdf5_column *column, size_t filled);

/* Into the block, and the first `count` of the block into the file from `first` on. */
TP_MUST_USE bool tp_hdf5_column_put(tp_hdf5_column *column, size_t at, tp_study_value value);
TP_MUST_USE bool tp_hdf5_column_write(tp_hdf5_column *column, uint64_t first, size_t count);

/* The same into a file in memory, and from there as HDF5 stores it behind `packed`; the texts of a
 * column of these as they are. */
TP_MUST_USE bool tp_hdf5_column_pack(tp_hdf5_column *column, tp_text *packed, uint64_t first,
                                     size_t count);
/* Into the file, from `*from` on, which goes on behind it, and not beyond `end`. */
TP_MUST_USE bool tp_hdf5_column_unpack(tp_hdf5_column *column, const char **from, const char *end,
                                       uint64_t first, size_t count);

#endif
