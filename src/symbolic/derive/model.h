/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene that was solved at its numbers and set up in symbols: what derivations begin with. The
 * numbers say which points touch, which pivot governs and which side a moment is on. */

#ifndef TP_DERIVE_MODEL_H
#define TP_DERIVE_MODEL_H

#include "derive/formulas.h"

typedef struct tp_model {
  tp_solution *solution;
  tp_problem problem;
  tp_symbols symbols;
  tp_formulas formulas; /* the boundary sums */
} tp_model;

/* Was the scene read, with names for its numbers? */
TP_MUST_USE tp_status tp_model_check_named(const tp_scene *scene, tp_message *message);

/* `elements`: prepare the elements too. `more` as for tp_field_init. On failure `model` is cleared.
 */
TP_MUST_USE tp_status tp_model_init(tp_model *model, const tp_scene *scene, bool elements,
                                    const tp_symbol_names *more, tp_message *message);
void tp_model_clear(tp_model *model);

/* The k-th pivot in symbols. */
TP_MUST_USE tp_status tp_model_pivot(tp_symbolic_point *pivot, const tp_model *model, size_t k,
                                     tp_message *message);

/* Lever arms of the weight about a point, both times six times the weighted area; x mirrored
 * towards the right. */
void tp_model_arms(fmpz_mpoly_q_t x_arm, fmpz_mpoly_q_t y_arm, const tp_model *model,
                   const tp_symbolic_point *pivot, tp_direction towards);

#endif
