/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles between the points of a loop (mend.h says which). */

#ifndef TP_SOLID_MEND_PATCH_H
#define TP_SOLID_MEND_PATCH_H

#include "solid/sides.h"
#include "solid/surface.h"

/* By numbers of points in the loop, in its sense, count - 2 of them; or none, where none are fit.
 * False when memory is exhausted. */
bool tp_mend_patch(int *triangles, long *patched, const tp_surface *surface, const tp_sides *sides,
                   const int *points, long count);

#endif
