/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the middle of a triangle lie inside of another closed surface of the same lattice, on which
 * it does not lie? Decided exactly; the cost is a few comparisons for each triangle. */

#ifndef TP_SOLID_INSIDE_H
#define TP_SOLID_INSIDE_H

#include "solid/surface.h"

bool tp_surface_has_inside(const tp_surface *surface, const tp_surface *other, long triangle);

#endif
