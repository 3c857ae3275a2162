/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What all questions of a solid on its contacts share. */

#ifndef TP_SOLID_TILT_CONTACT_WORK_H
#define TP_SOLID_TILT_CONTACT_WORK_H

#include "solid_contacts/hold.h"
#include "solid_contacts/solid_section.h"
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

/* Rounded to doubles. */
tp_solid_section_inertia tp_contacts_inertia(const tp_contact_work *work);

/* What forces hold in a state: with the earthquake, or without. */
typedef struct tp_weak_side {
  tp_hold_load load, rest, way; /* rest + way = load, and way is what drives */
  bool drives;
  tp_hold_side side;
  double twist[TP_WRENCH]; /* if side == TP_HOLD_MOVES */
  double least;            /* the least normal force of those found, at most */
  bool rests;              /* what rests is held, or the load */
  tp_hold_limit limit;     /* of rest + t way, where it is */
  tp_hold_factor_kind kind;
  tp_near factor; /* of friction */
  double beyond[TP_WRENCH];
} tp_weak_side;

#endif
