/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Has the contact an area that a normal stress can be the mean over? */

#ifndef TP_PROBLEM_CONTACT_WIDTH_H
#define TP_PROBLEM_CONTACT_WIDTH_H

#include "base/contact.h"

/* Refuse Barton's law on a contact that has no width along the mean plane, points alone or upright
 * faces, unless the scene states one: force over no area is no stress. */
TP_MUST_USE tp_status tp_contact_width_check(const tp_contact *contact, const tp_lattice *lattice,
                                             const tp_scene *scene, tp_message *message);

#endif
