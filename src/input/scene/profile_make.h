/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A base profile made by its rule. `line` is empty before, and stays so on failure. */

#ifndef TP_SCENE_PROFILE_MAKE_H
#define TP_SCENE_PROFILE_MAKE_H

#include "scene/profile_rule.h"

/* With noise, scaling and wear, ready to be shared. */
TP_MUST_USE tp_status tp_profile_make(tp_polyline *line, const tp_profile_rule *rule,
                                      const fmpq_t metres_per_unit, tp_message *message);

/* What it begins with. */
TP_MUST_USE tp_status tp_rule_make_teeth(tp_polyline *line, const tp_profile_rule *rule,
                                         tp_message *message);
TP_MUST_USE tp_status tp_rule_make_self_affine(tp_polyline *line, const tp_profile_rule *rule,
                                               tp_message *message);

#endif
