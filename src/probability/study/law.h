/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By what a number varies, in words: "mean 36, deviation 3, between 25 and 50". */

#ifndef TP_STUDY_LAW_H
#define TP_STUDY_LAW_H

#include "study/study.h"

/* To be freed; NULL when memory is exhausted. */
char *tp_study_law(const tp_variable *variable);

#endif
