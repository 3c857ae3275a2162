/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on contact points at the tilt of its scene: whether forces hold it, and by how much
 * friction may be divided, and what drives it multiplied, until none do; whether a motion can
 * begin, and its factor of safety (contact_strong.h). */

#ifndef TP_SOLID_TILT_CONTACT_STANCE_H
#define TP_SOLID_TILT_CONTACT_STANCE_H

#include "solid_tilt/contact_work.h"

/* Verdict, forces, a motion where none hold it, and the factors, into the results. */
TP_MUST_USE tp_status tp_contact_stance_find(tp_contact_work *work);

#endif
