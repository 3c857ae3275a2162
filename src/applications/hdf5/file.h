/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A file of HDF5 that is being made, under another name beside it, and what HDF5 says where that
 * fails. */

#ifndef TP_HDF5_FILE_H
#define TP_HDF5_FILE_H

#include "common/message.h"

#include <hdf5.h>

typedef struct tp_hdf5_file {
  const char *path, *csv; /* csv: the rows it is made of, for messages */
  char *target, *part;    /* where links lead, and the name until it is whole */
  hid_t id;
  char reason[200]; /* of the first call that failed; empty: none did */
} tp_hdf5_file;

/* Is it the rows of a study? */
TP_MUST_USE bool tp_hdf5_file_is_ours(const char *path);

/* To be ended, also on failure; it stays where it is until then. */
TP_MUST_USE tp_status tp_hdf5_file_begin(tp_hdf5_file *file, const char *path, const char *csv,
                                         tp_message *message);
/* One in memory alone, of which chunks are taken; likewise, and never whole. */
TP_MUST_USE tp_status tp_hdf5_file_begin_in_memory(tp_hdf5_file *file, const char *path,
                                                   const char *csv, tp_message *message);
/* Where `status` is TP_OK and all is written, by its name; else nothing is left. */
TP_MUST_USE tp_status tp_hdf5_file_end(tp_hdf5_file *file, tp_status status, bool whole,
                                       tp_message *message);

/* Why the first of its calls failed. */
tp_status tp_hdf5_fail(const tp_hdf5_file *file, tp_message *message);

/* An attribute of the object: a text, or a whole number. */
TP_MUST_USE bool tp_hdf5_note_text(hid_t object, const char *name, const char *text);
TP_MUST_USE bool tp_hdf5_note_count(hid_t object, const char *name, uint64_t count);

#endif
