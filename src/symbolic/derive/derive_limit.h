/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas of the static limit, written: the certified solve names the two columns that hold last,
 * and tan(alpha) follows from them in the field (derive/limit_formulas.h), with
 * the conditions under which they stay the ones. */

#ifndef TP_DERIVE_DERIVE_LIMIT_H
#define TP_DERIVE_DERIVE_LIMIT_H

#include "derive/limit_formulas.h"

/* The symbol that they take besides the scene's parameters. */
#define TP_DERIVE_LIMIT_SYMBOL "tan(phi)"

/* Refuse a scene without friction, or with a parameter of the symbol's name. */
TP_MUST_USE tp_status tp_derive_limit_check(const tp_scene *scene, tp_message *message);

/* The scene's parameters, and tan(phi) at its friction: for all symbols of the model's field. */
void tp_derive_limit_values(arb_ptr values, const tp_model *model, long friction, long bits);

/* Of a case of the model, whose field has the symbol at `friction`. `*failed` is set when memory is
 * exhausted. */
TP_MUST_USE tp_status tp_derive_limit(tp_derived_limit *out, const tp_model *model,
                                      const tp_case *own, long friction,
                                      const tp_derive_options *options, bool *failed,
                                      tp_message *message);
void tp_derived_limit_free(tp_derived_limit *limit);

#endif
