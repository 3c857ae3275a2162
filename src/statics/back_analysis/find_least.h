/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The direction of an anchor at which the least force gives a wanted result. */

#ifndef TP_BACK_ANALYSIS_FIND_LEAST_H
#define TP_BACK_ANALYSIS_FIND_LEAST_H

#include "back_analysis/find_sample.h"

/* Search the direction that options->least_over names, and the force there. The scene with that
 * direction is to be looked at after it: what it finds is certain, and this is not. */
TP_MUST_USE tp_status tp_search_least(double *direction_deg, double *force_kn, tp_search *search);

#endif
