/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What of a body lies above a plane that cuts it, as a body that rests on the section: what lies
 * below is ground. */

#ifndef TP_SOLID_TILT_SOLID_CUT_H
#define TP_SOLID_TILT_SOLID_CUT_H

#include "solid_tilt/solid_body.h"
#include "solid_tilt/solid_given.h"

typedef struct tp_solid_cut {
  tp_solid_body body;
  tp_surface *surfaces; /* of the rock and of its parts */
  long count;
} tp_solid_cut;

/* At the height that is given over the lowest point. Refused where nothing lies above, or more than
 * one piece of rock. To be cleared where it was made. */
TP_MUST_USE tp_status tp_solid_cut_init(tp_solid_cut *cut, const tp_solid_body *body,
                                        const tp_solid_given *given, tp_message *message);
void tp_solid_cut_clear(tp_solid_cut *cut);

#endif
