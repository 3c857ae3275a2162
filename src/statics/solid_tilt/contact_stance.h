/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on contact points at the tilt of its scene: whether forces hold it, and by how much
 * friction may be divided, and what drives it multiplied, until none do. */

#ifndef TP_SOLID_TILT_CONTACT_STANCE_H
#define TP_SOLID_TILT_CONTACT_STANCE_H

#include "solid_contacts/hold.h"
#include "solid_tilt/contact_points.h"
#include "solid_tilt/least_way.h"

/* What all questions of one solid on its contacts share. */
typedef struct tp_contact_work {
  tp_solid_contacts *results;
  const tp_surface *surface;
  const tp_solid_given *given;
  tp_contact_points points;
  tp_hold hold;
  tp_hold_frame frame;
  tp_level_loads level, tilted;
  tp_message *message;
} tp_contact_work;

tp_status tp_contacts_fail_memory(const tp_contact_work *work);

/* The screw of a twist that begins. */
void tp_contacts_motion(tp_solid_motion *motion, const tp_contact_work *work,
                        const double twist[TP_WRENCH]);

/* Verdict, forces, a motion where none hold it, and the factors, into the results. */
TP_MUST_USE tp_status tp_contact_stance_find(tp_contact_work *work);

#endif
