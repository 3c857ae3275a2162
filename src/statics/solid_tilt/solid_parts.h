/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene puts inside a solid: what it adds to the moments, and what results say of it. */

#ifndef TP_SOLID_TILT_SOLID_PARTS_H
#define TP_SOLID_TILT_SOLID_PARTS_H

#include "solid_tilt/solid_body.h"
#include "solid_tilt/solid_given.h"

/* For each part of the body, to be cleared. NULL where it has none. */
TP_MUST_USE tp_status tp_solid_parts_weigh(tp_solid_part_moments **parts, const tp_solid_body *body,
                                           const tp_solid_given *given, tp_message *message);
void tp_solid_parts_clear(tp_solid_part_moments *parts, long part_count);

TP_MUST_USE tp_status tp_solid_parts_tell(tp_solid *solid, const tp_solid_body *body,
                                          const tp_solid_given *given, tp_message *message);

#endif
