/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The engines of dynamics behind one face, each with the settings of the test. */

#ifndef TP_TILT_ENGINES_H
#define TP_TILT_ENGINES_H

#include "contact_springs/springs.h"
#include "rigid_contact/rigid_contact.h"
#include "tilt/trial.h"

typedef struct tp_tilt_engines {
  tp_spring_settings springs;
  tp_rigid_contact_settings rigid;
  /* What any of the runs on rigid contacts met. */
  bool paradox, in_window, lowered_restitution, accumulated;
} tp_tilt_engines;

/* That of the settings; `own` must outlive what is returned. Bad input where springs cannot be
 * stepped so: the message says what would do. */
TP_MUST_USE tp_status tp_tilt_dynamics_of(tp_tilt_dynamics *dynamics, tp_tilt_engines *own,
                                          const tp_tilt_settings *s, const tp_rigid_body *body,
                                          tp_place place, tp_message *message);

/* How the block begins to move at a tilt, by the first of the motions that rigid contacts allow
 * there: its acceleration in the place of a speed. False where none can begin. */
TP_MUST_USE bool tp_tilt_engines_begin(tp_body_state *moving, const tp_tilting *tilting,
                                       double angle_deg);

/* Notes on what they met. */
TP_MUST_USE tp_status tp_tilt_engines_notes(tp_notes *notes, const tp_tilt_engines *own,
                                            tp_place place, tp_message *message);

#endif
