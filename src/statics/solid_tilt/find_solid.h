/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results of a body as it is: one that no plane cuts, or what one has cut off. */

#ifndef TP_SOLID_TILT_FIND_SOLID_H
#define TP_SOLID_TILT_FIND_SOLID_H

#include "solid_tilt/solid_body.h"
#include "solid_tilt/solid_given.h"

/* As tp_solid_find. */
TP_MUST_USE tp_status tp_solid_find_body(tp_solid *solid, const tp_solid_body *body,
                                         tp_solid_given *given, tp_message *message);

#endif
