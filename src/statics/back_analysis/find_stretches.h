/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Between which numbers of a range a result is at least the wanted value. */

#ifndef TP_BACK_ANALYSIS_FIND_STRETCHES_H
#define TP_BACK_ANALYSIS_FIND_STRETCHES_H

#include "back_analysis/find_sample.h"

/* Fill in found->at_least from all numbers that were tried; how it went is in search->status. */
void tp_search_stretches(tp_search *search);

#endif
