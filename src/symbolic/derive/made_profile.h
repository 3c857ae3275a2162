/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A base profile made by rule enters formulas by its numbers: none of what makes it may be a
 * symbol. */

#ifndef TP_DERIVE_MADE_PROFILE_H
#define TP_DERIVE_MADE_PROFILE_H

#include "scene/scene.h"

/* `profile` is the node of the base's profile. */
TP_MUST_USE tp_status tp_made_profile_check(const tp_scene *scene, const tp_node *profile,
                                            tp_message *message);

#endif
