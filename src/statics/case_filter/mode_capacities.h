/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What cohesion and bonds do in one mode of a plan (motion/strength.h), in doubles with bounds. */

#ifndef TP_CASE_FILTER_MODE_CAPACITIES_H
#define TP_CASE_FILTER_MODE_CAPACITIES_H

#include "case_filter/capacities.h"

enum { TP_MODE_FREE = 3, TP_MODE_PULLS = 2 };

/* On the block, over the weight. */
typedef struct tp_mode_capacities {
  tp_near fixed[3]; /* of lines that slip and facets that open; */
  int free_count;   /* of lines that stick, times anything from -1 to 1, */
  tp_near free[TP_MODE_FREE][3];
  long free_site[TP_MODE_FREE]; /* by the point that sticks; */
  int pull_count; /* of bonded facets that slide, turned round, times anything above zero */
  tp_near pulls[TP_MODE_PULLS][3];
  long pull_site[TP_MODE_PULLS];
} tp_mode_capacities;

/* False where there is no room for it, or doubles do not tell. */
TP_MUST_USE bool tp_mode_capacities_find(tp_mode_capacities *own, const tp_filter_case *of,
                                         const tp_plan_mode *mode);

/* All bonds, which hold where all facets open. */
void tp_bonds_of_all(tp_near pull[3], const tp_filter_capacities *capacities);

#endif
