/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A folder of this process for the files of studies, removed at its end. */

#ifndef TP_TEST_FUZZ_STUDY_FOLDER_H
#define TP_TEST_FUZZ_STUDY_FOLDER_H

#include <stddef.h>

/* The path of a file in it. A scene is there, slab.yaml, and a table of numbers, table.csv. */
const char *fuzz_study_path(char path[200], const char *name);

void fuzz_study_write(const char *name, const char *text, size_t length);

#endif
