/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas of a rounded corner, written: tan(alpha) about the axis where rounding puts it, with the
 * tangent length and the angle of its flank as symbols (Eqs. 4 and 5; derive/rounding.h). */

#ifndef TP_DERIVE_DERIVE_ROUNDING_H
#define TP_DERIVE_DERIVE_ROUNDING_H

#include "derive/rounding.h"

/* The symbols that they take besides the scene's parameters. */
extern const tp_symbol_names tp_derive_rounding_symbols;

/* Refuse a scene whose parameters have the names of those symbols. */
TP_MUST_USE tp_status tp_derive_rounding_check(const tp_scene *scene, tp_message *message);

/* About the governing pivot of a case of the model, which has the symbols. `*failed` is set when
 * memory is exhausted. */
TP_MUST_USE tp_status tp_derive_rounding(tp_derived_rounding *out, const tp_model *model,
                                         const tp_case *own, tp_notation notation, bool *failed,
                                         tp_message *message);
void tp_derived_rounding_free(tp_derived_rounding *rounding);

#endif
