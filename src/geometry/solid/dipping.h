/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base of a solid that lies on a slope, by its dip d and dip direction a. In the frame that the
 * least turn of `up`, which is the vertical, brings upright (solid/azimuth.h), it has the normal
 * m = (sin d sin a, sin d cos a, cos d), taken to 2^-100. With up = (x, y, z), L = |up| and
 * h = m_x x + m_y y that turn brings back
 *     L (L + z) n = (m_x L (L + z) + x k, m_y L (L + z) + y k, (L + z) (m_z z - h)),
 * k = m_z (L + z) - h: whole numbers without a further rounding where L is one, so that a mesh
 * turned by a rational matrix decides as the one with z upwards does; else L is taken to 2^-200 of
 * L + z, and n to 2^-200. Upside down the turn is that about x. A base without dip is level, and
 * its normal `up` itself. */

#ifndef TP_SOLID_DIPPING_H
#define TP_SOLID_DIPPING_H

#include "solid/azimuth.h"

#include <flint/fmpq.h>

/* Into the normal of the base, in the axes of the mesh and of any length, and its east and north:
 * those of the vertical's frame, turned down the dip. `up` is not zero and not the normal. */
void tp_dipping_base_set(fmpz normal[3], tp_map_frame *frame, const fmpz up[3],
                         const fmpq_t dip_deg, const fmpq_t direction_deg);

#endif
