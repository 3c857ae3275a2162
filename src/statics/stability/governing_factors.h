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

/* Fills in the factors that are known: by moments and by shear strength; and, where the onset was
 * asked for, by strength and by the tilt: then true, with the tilt at which motions begin, or end.
 */
void tp_governing_add_formulas(tp_governing_fos *governing, const tp_at_scene *at);
bool tp_governing_add_onset(tp_governing_fos *governing, const tp_at_scene *at,
                            tp_bounded *end_deg);

#endif
