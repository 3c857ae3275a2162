/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the files that apply partial factors, and tell of them, share. */

#ifndef TP_SCENE_FACTORED_H
#define TP_SCENE_FACTORED_H

#include "scene/partial_factors.h"

/* Groups of actions, by their bits in a combination. */
typedef enum tp_action_group {
  TP_ACTION_WEIGHT,
  TP_ACTION_WATER,
  TP_ACTION_PRESSURES, /* and forces from outside, of many blocks */
  TP_ACTION_SURCHARGES,
  TP_ACTION_GROUPS
} tp_action_group;

/* Is there an action of a group? And with another factor where it is favourable? */
bool tp_action_acts(const tp_scene *scene, tp_action_group group);
bool tp_action_has_two(const tp_scene *scene, tp_action_group group);
/* What those of a group are multiplied by; and any other action. */
void tp_action_factor(fmpq_t factor, const tp_scene *scene, tp_action_group group,
                      unsigned combination);
void tp_action_factor_of(fmpq_t factor, const tp_partial_factors *own, tp_partial_factor which);

/* A number that a factored scene shares becomes its own, times a factor, or over a divisor. */
void tp_factored_scale(fmpq_t value, const fmpq_t factor);
void tp_factored_scale_over(fmpq_t value, const fmpq_t divisor);
/* A copy of an array, with room for one at least; NULL where memory is exhausted. */
void *tp_factored_copy(const void *items, long count, size_t size);

/* Of many blocks the unit weights that they say themselves, and the strengths of joints and of sets
 * of joints. False when memory is exhausted; given back by tp_factored_blocks_clear anyhow. */
TP_MUST_USE bool tp_factored_blocks_init(tp_scene *factored, const fmpq_t weight,
                                         const fmpq_t cohesion);
void tp_factored_blocks_clear(tp_scene *factored);

#endif
