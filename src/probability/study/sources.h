/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The files that a study rests on, in the order of its fingerprint (tp_study.hash): its own, those
 * of its scene, and those of its columns, one for each number that is read from one. */

#ifndef TP_STUDY_SOURCES_H
#define TP_STUDY_SOURCES_H

#include "study/study.h"

#include <sys/stat.h>

size_t tp_study_source_count(const tp_study *study);
const char *tp_study_source(const tp_study *study, size_t k);

/* Is this file one of them? */
bool tp_study_reads(const tp_study *study, const struct stat *file);

#endif
