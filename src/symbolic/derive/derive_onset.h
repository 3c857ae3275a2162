/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas of the onset of motion, written: the plane at which the first motion begins, its tangent
 * and its conditions, from derive/onset_formulas.h. */

#ifndef TP_DERIVE_DERIVE_ONSET_H
#define TP_DERIVE_DERIVE_ONSET_H

#include "derive/model.h"

/* Of a case of the model, beside its limit; as tp_derive_limit. What cannot be derived says why,
 * and is no failure. */
TP_MUST_USE tp_status tp_derive_onset(tp_derived_onset *out, const tp_derived_limit *limit,
                                      const tp_model *model, const tp_case *own, long friction,
                                      const tp_derive_options *options, bool *failed,
                                      tp_message *message);
void tp_derived_onset_free(tp_derived_onset *onset);

#endif
