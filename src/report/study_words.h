/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The words of a study's summary, on the page and in JSON. */

#ifndef TP_REPORT_STUDY_WORDS_H
#define TP_REPORT_STUDY_WORDS_H

#include "topple.h"

/* As on the page: critical angle, and so on. */
const char *tp_study_quantity_words(tp_study_quantity quantity);

/* complete, certain, interrupted or shard. */
const char *tp_study_end_name(tp_study_end end);

#endif
