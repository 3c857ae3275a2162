/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moment sums of a toothed block as functions of its number of teeth. */

#ifndef TP_DERIVE_FAMILY_H
#define TP_DERIVE_FAMILY_H

#include "derive/formulas.h"

enum { TP_FAMILY_SUMS = 3 };

/* Twice the area and six times the first moments, for every N of one parity. */
typedef struct tp_family_sums {
  fmpz_mpoly_q_t of[TP_FAMILY_SUMS];
} tp_family_sums;

void tp_family_sums_init(tp_family_sums *sums, const tp_field *field);
void tp_family_sums_clear(tp_family_sums *sums, const tp_field *field);

/* Refuse scenes that have no family: other blocks than toothed ones without holes and parts. */
TP_MUST_USE tp_status tp_family_check(const tp_scene *scene, tp_message *message);

TP_MUST_USE tp_status tp_family_sums_derive(tp_family_sums *sums, bool even,
                                            const tp_teeth_formulas *f, const tp_scene *scene,
                                            const tp_field *field, tp_message *message);

tp_pivot_kind tp_family_toe_kind(const tp_scene *scene, bool even, tp_direction towards);

/* Six times the first moments about the toe of one direction, x mirrored towards the right. The
 * left toe is at (0, 0 or c), the right one at (N a, 0 or c). */
void tp_family_arms(fmpz_mpoly_q_t x_arm, fmpz_mpoly_q_t y_arm, const tp_family_sums *sums,
                    const tp_teeth_formulas *f, tp_pivot_kind kind, tp_direction towards,
                    const tp_field *field);

#endif
