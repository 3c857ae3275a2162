/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is found of a support: its force per metre, and the force to build for. */

#ifndef TP_BACK_ANALYSIS_FIND_SUPPORT_H
#define TP_BACK_ANALYSIS_FIND_SUPPORT_H

#include "back_analysis/find_sample.h"

/* Fill in found->per_metre_kn, of bolts at a spacing; how it went is in search->status. */
void tp_search_per_metre(tp_search *search);

/* Fill in the design of what was found: of the force of a bolt or the pressure of a lining. */
void tp_search_design(tp_search *search);

#endif
