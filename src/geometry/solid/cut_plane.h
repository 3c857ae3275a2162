/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A plane that cuts a solid, in the whole numbers of its surface. */

#ifndef TP_SOLID_CUT_PLANE_H
#define TP_SOLID_CUT_PLANE_H

#include "solid/surface.h"

/* Points with up . whole = top / bottom, of a surface's whole numbers; and one of them, from which
 * what is cut off has its numbers, with the exponent of its doubles. */
typedef struct tp_cut_plane {
  fmpz up[3];
  fmpz_t top, bottom; /* bottom above 0 */
  fmpz origin[3];     /* to be divided by */
  fmpz_t weight;      /* 0: not chosen yet */
  long exponent;      /* of the doubles of all that is cut off; 0: not chosen yet */
} tp_cut_plane;

/* At a height over the lowest point of a surface, 0 or more, in lengths of the mesh: exactly where
 * |up| is rational, else to 2^-200 of itself. To be cleared. */
void tp_cut_plane_init(tp_cut_plane *plane, const tp_surface *surface, const fmpz up[3],
                       const fmpq_t height);
void tp_cut_plane_clear(tp_cut_plane *plane);

/* up . point */
void tp_cut_height(fmpz_t height, const tp_cut_plane *plane, const fmpz *point);

#endif
