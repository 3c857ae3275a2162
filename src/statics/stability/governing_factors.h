/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factors against the ways in which a block can move at the scene's tilt, and which of them
 * count (topple_governing.h). */

#ifndef TP_STABILITY_GOVERNING_FACTORS_H
#define TP_STABILITY_GOVERNING_FACTORS_H

#include "topple_solution.h"

/* From the least safe on: none at all, a number, unknown, unbounded. */
typedef enum tp_fos_rank {
  TP_RANK_NONE,
  TP_RANK_NUMBER,
  TP_RANK_UNDECIDED,
  TP_RANK_UNBOUNDED,
  TP_RANK_ABSENT
} tp_fos_rank;

tp_fos_rank tp_fos_rank_of(tp_fos fos);
bool tp_fos_is_less(tp_fos one, tp_fos other);
/* Certainly below 1, or none; certainly above 1, or unbounded. */
bool tp_fos_is_below(tp_fos fos);
bool tp_fos_is_above(tp_fos fos);

/* What is known of a case at its tilt. */
typedef struct tp_at_scene {
  const tp_case *c;
  const tp_solution *solution;
  bool moves, stands; /* neither: that is undecided, or friction is not given */
} tp_at_scene;

tp_at_scene tp_at_scene_of(const tp_case *own, const tp_solution *solution);

/* Fills in the factors that are known, in this order: by moments, by shear strength, on driving
 * loads and by strength reduction. Where the onset was not asked for the formulas alone are known,
 * and all of them count. */
void tp_governing_add_factors(tp_governing_fos *governing, const tp_at_scene *at);

/* The tilt at which the factor on driving loads is 1, of the weight alone; false: there is none. */
bool tp_governing_tilt(tp_bounded *degrees, const tp_at_scene *at);

#endif
