/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The numbers of a range at which a result has a wanted value. */

#ifndef TP_BACK_ANALYSIS_FIND_SEARCH_H
#define TP_BACK_ANALYSIS_FIND_SEARCH_H

#include "back_analysis/find_sample.h"

/* Fill in what is found from found->low to found->high, and cut that to where the scene has an
 * answer; how it went is in search->status. */
void tp_search_scan(tp_search *search);

#endif
