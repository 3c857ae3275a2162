/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Can a motion begin in which each contact has the mode that is asked for, or one next to it?
 * Proven by one: what closed ends and sticking allow is a space of accelerations, found in whole
 * numbers, so that these laws hold exactly; Newton's law for every block then is a linear system in
 * accelerations of that space and in forces of the modes, of which a solution is enclosed
 * (contact_modes/mode_equations.h); and all that must not be negative is certainly not
 * (contact_modes/mode_laws.h). Where something is, the modes of these contacts are changed, and the
 * system is solved anew, a few times. */

#ifndef TP_CONTACT_MODES_BEGINNING_H
#define TP_CONTACT_MODES_BEGINNING_H

#include "contact_modes/trial_mode.h"

/* `trial`, by contact, are the modes to begin from, and where a motion is proven its own;
 * `accelerations`, by row, are those of the motion then. */
TP_MUST_USE tp_status tp_beginning_prove(bool *proven, double *accelerations, tp_trial_mode *trial,
                                         const tp_beginning_question *question,
                                         tp_message *message);

#endif
