/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Do forces hold all blocks? What each block lacks for equilibrium is carried along a tree of
 * contacts to the ground, and added to what each contact of the tree exerts: all factors, enclosed,
 * are then to be no less than zero, and no more than they may. */

#ifndef TP_ASSEMBLAGE_HELD_FORCES_H
#define TP_ASSEMBLAGE_HELD_FORCES_H

#include "assemblage/ground_tree.h"

/* `forces` are by column; `lacks` is room by row. */
bool tp_forces_hold(tp_near *lacks, const tp_force_program *program, const tp_ground_tree *tree,
                    const double *forces, tp_near load);

#endif
