/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Can a motion begin in which each contact has the mode that is asked for? Proven by one: what
 * closed ends and sticking allow is a space of accelerations, found in whole numbers, so that these
 * laws hold exactly; Newton's law for every block then is a linear system in accelerations of that
 * space and in forces of the modes, of which a solution is enclosed (contact_modes/basis_proof.h);
 * and all that must not be negative is certainly not: openings, slips to their side, normal forces,
 * and friction in reserve where a contact sticks. */

#ifndef TP_CONTACT_MODES_BEGINNING_H
#define TP_CONTACT_MODES_BEGINNING_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

typedef struct tp_beginning_question {
  const tp_resting *resting;
  const tp_mode_set *modes;       /* one a contact */
  const tp_near *friction;        /* by contact */
  const tp_near *loads;           /* w by row */
  const double *normals, *shears; /* 2 a contact: forces to begin from */
} tp_beginning_question;

/* `accelerations`, by row, are those of the motion where it is proven. */
TP_MUST_USE tp_status tp_beginning_prove(bool *proven, double *accelerations,
                                         const tp_beginning_question *question,
                                         tp_message *message);

#endif
