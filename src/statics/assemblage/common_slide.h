/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Do loads drive all free blocks together along a line, on which none is pressed into ground? Then
 * no normal forces alone hold them: a wall on a plane that dips, say. In doubles, to pass over a
 * search that would find nothing. */

#ifndef TP_ASSEMBLAGE_COMMON_SLIDE_H
#define TP_ASSEMBLAGE_COMMON_SLIDE_H

#include "assemblage/force_program.h"

/* Of a program in normal forces, with so much of the live load. */
bool tp_common_slide(const tp_force_program *normals, double load);

#endif
