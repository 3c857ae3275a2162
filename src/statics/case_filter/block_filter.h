/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The case filter of one block under its weight alone on its mated base, which ends with it, of an
 * outline in doubles: its contact planned in doubles, too (near_plan.h). */

#ifndef TP_CASE_FILTER_BLOCK_FILTER_H
#define TP_CASE_FILTER_BLOCK_FILTER_H

#include "case_filter/case_filter.h"
#include "case_filter/parallel_facets.h"

/* Fills in all that tp_case_filter_tell reads; false where doubles do not tell. The tangent of the
 * friction angle tells which of many facets are looked at. */
TP_MUST_USE bool tp_block_filter_init(tp_case_filter *filter, const tp_block_underside *underside,
                                      tp_direction towards, double friction);

#endif
