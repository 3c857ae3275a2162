/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The texts of the files that a study rests on, as attributes of the file. */

#ifndef TP_HDF5_TEXTS_H
#define TP_HDF5_TEXTS_H

#include "hdf5/file.h"
#include "study/study.h"

/* `study` and `scene` of the root, and with the group `files` one for each file that they name, by
 * its path. Bad input where one has changed since the study was read. */
TP_MUST_USE tp_status tp_hdf5_note_texts(const tp_hdf5_file *file, const tp_study *study,
                                         tp_message *message);

#endif
