/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Factors of a solid, state by state, under the rule of verdict/safety.h.
 *
 * A scene with an earthquake has two states, with and without it, as a body that falls without an
 * earthquake is not made safe by one that pushes it back. On a ground the same again with the mean
 * of all normals. */

#ifndef TP_SOLID_TILT_SOLID_SAFETY_H
#define TP_SOLID_TILT_SOLID_SAFETY_H

#include "number/near.h"
#include "topple.h"
#include "verdict/safety.h"

/* A state under way. */
typedef struct tp_state_ranges {
  bool is_static;
  tp_motion_verdict verdict;
  size_t count;
  tp_factor_range ranges[TP_SOLID_FACTORS];
} tp_state_ranges;

/* One more factor of it. */
void tp_state_ranges_add(tp_state_ranges *state, tp_fos_definition definition,
                         tp_mechanism mechanism, double least, double most);
/* The bounds of a number, not below zero; both infinite where it is. */
void tp_state_ranges_add_near(tp_state_ranges *state, tp_fos_definition definition,
                              tp_mechanism mechanism, tp_near number);

/* One more state, and what governs of all. */
void tp_solid_safety_add(tp_solid_safety *safety, const tp_state_ranges *state);
/* The states of another one as well, as those with the mean of all normals. */
void tp_solid_safety_add_mean(tp_solid_safety *safety, const tp_solid_safety *mean);

tp_design tp_solid_safety_meets(const tp_solid_safety *safety, double required);

/* As a number, where it is one. */
bool tp_solid_safety_number(tp_bounded *fos, tp_mechanism *mechanism,
                            const tp_solid_safety *safety);

#endif
