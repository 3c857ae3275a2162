/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The engines of dynamics behind one face, each with the settings of the test. */

#ifndef TP_TILT_ENGINES_H
#define TP_TILT_ENGINES_H

#include "contact_springs/springs.h"
#include "rigid_contact/rigid_contact.h"
#include "tilt/trial.h"

typedef struct tp_tilt_engine_settings {
  tp_spring_settings springs;
  tp_rigid_contact_settings rigid;
} tp_tilt_engine_settings;

/* `own` must outlive what is returned. */
tp_tilt_dynamics tp_tilt_dynamics_of(tp_tilt_engine_settings *own, const tp_tilt_settings *s);

#endif
