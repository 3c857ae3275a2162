/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear program of forces between blocks whose joints do not dilate:
 *
 *     maximise s subject to  A f + w0 + s w1 = 0,  N >= 0,  |T| <= C.
 *
 * The shear strength C of each contact is a given force, whatever its normal forces are. So the
 * mechanism, which is the dual of the program, slips along a contact without opening it. Columns
 * are a normal force at each end, and a shear force along the contact from 0 to 2 C, half of which
 * w0 has back. Tensile strength shifts normal forces as in assemblage/force_program.h. */

#ifndef TP_ASSEMBLAGE_CONSTANT_SHEAR_H
#define TP_ASSEMBLAGE_CONSTANT_SHEAR_H

#include "assemblage/force_program.h"

/* `shear` is C by contact, in the units of the columns of that contact. Strengths give the tension
 * and, by their tangents, those units, as tp_contact_frame_of does. On failure `program` is
 * cleared. */
TP_MUST_USE tp_status tp_constant_shear_program(tp_force_program *program,
                                                const tp_assemblage *assemblage,
                                                const tp_contact_strength *strengths,
                                                const double *shear, const tp_weight_loads *loads,
                                                tp_message *message);

/* The normal force of a contact by the forces of such a program, plus its tensile strength. */
double tp_constant_shear_normal(const tp_force_program *program, const double *forces,
                                long contact);

#endif
