/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* First-order admissibility of pivots (Reuleaux; docs/mechanics.md section 3). */

#ifndef TP_PROBLEM_ADMISSIBLE_H
#define TP_PROBLEM_ADMISSIBLE_H

#include "base/contact.h"

/* For each contact point: does turning about it, in the sense of toppling towards `direction`, open
 * or keep every facet? Exact. Towards the left the block turns counter-clockwise, and the facet
 * from q0 to q1 with direction t stays clear of the base if and only if (q0 - P) . t >= 0; towards
 * the right if and only if (P - q1) . t >= 0. */
void tp_admissible_find(bool *admissible, const tp_contact *contact, const tp_lattice *lattice,
                        tp_direction direction);

#endif
