/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on a mesh of the ground: for each band of its scene the contacts within it
 * (ground/ground_contacts.h), and what the solid does on them. With a larger band there are no
 * fewer contacts and no load is held less, so that the least governs. */

#ifndef TP_SOLID_TILT_ON_GROUND_H
#define TP_SOLID_TILT_ON_GROUND_H

#include "solid/centre.h"
#include "solid_tilt/solid_body.h"
#include "solid_tilt/solid_given.h"

/* Of a scene with a ground, into the solid; moments at the level exact. Refused: a solid that
 * enters its ground deeper than the least band, that has no contact within it, or more of them than
 * TP_SOLID_CONTACTS. */
TP_MUST_USE tp_status tp_on_ground_find(tp_solid *solid, const tp_solid_body *body,
                                        const tp_solid_moments *moments,
                                        const tp_solid_given *given, tp_message *message);
void tp_solid_ground_clear(tp_solid_ground *ground);

#endif
