/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The step within which a contact closes or opens, so that its energy is accounted for.
 *
 * Central differences take the force at a position for half of the step to it and half of the one
 * from it. The work of a whole step against a linear spring is exact; not so where the spring
 * begins or ends within a step of length d. With an overlap u < d after it, or before it, the
 * spring k holds k u^2 / 2, and the step takes, or gives, k u d / 2. A force of k u (1 - u / d) / 2
 * against the spring's, once, at the position after the step, makes up for that. Without it a
 * vibration loses or gains up to (omega dt)^2 / 8 of its energy as a contact closes and opens; with
 * it an error of third order is left, as the next step is not quite the last one.
 */

#ifndef TP_CONTACT_SPRINGS_CROSSING_H
#define TP_CONTACT_SPRINGS_CROSSING_H

#include "contact_springs/contact.h"

/* Of a contact that has closed in a step and is loaded by its springs. */
void tp_spring_closes(tp_spring_forces *forces, tp_spring_contact *own, tp_xy displaced,
                      double turned);

/* Of one that has opened in it: `own` as it was before, and the stiffness of a square metre. */
void tp_spring_opens(tp_spring_forces *forces, const tp_spring_contact *own, double normal_pa_m,
                     tp_xy displaced, double turned);

/* What friction takes as the normal force goes, and Coulomb's limit lets the shear spring go slack:
 * what that held, and its work in this last step. */
double tp_spring_let_go(const tp_spring_contact *own, double shear_pa_m, tp_xy displaced,
                        double turned);

#endif
