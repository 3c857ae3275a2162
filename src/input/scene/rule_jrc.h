/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Profiles of a wanted JRC, and what is to be told of them. */

#ifndef TP_SCENE_RULE_JRC_H
#define TP_SCENE_RULE_JRC_H

#include "common/notes.h"
#include "scene/profile_rule.h"

/* The Z2 that a JRC has by Tse and Cruden (1979). */
void tp_z2_of_jrc(fmpq_t z2, const fmpq_t jrc);

/* In place of a standard profile; `line` is empty before, and stays so on failure. */
TP_MUST_USE tp_status tp_rule_make_standard(tp_polyline *line, const tp_profile_rule *rule,
                                            const fmpq_t metres_per_unit, tp_message *message);

/* Notes on a rule that asks for a JRC. */
TP_MUST_USE tp_status tp_profile_rule_notes(tp_notes *notes, const tp_profile_rule *rule,
                                            const fmpq_t metres_per_unit, tp_message *message);

#endif
