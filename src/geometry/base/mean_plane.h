/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mean plane of a contact, exactly: a direction of whole or rational components.
 *
 * Least squares across the line between both ends of the contact: with a along that line and b
 * normal to it the straight line b = m a + c with the least integral of its squared distance (in b)
 * from the contact, over |da|. The sums are those of the facets,
 *     L = sum |da|,  S_a = sum |da| (a0 + a1) / 2,  S_aa = sum |da| (a0^2 + a0 a1 + a1^2) / 3,
 *     S_ab = sum |da| (2 a0 b0 + a0 b1 + a1 b0 + 2 a1 b1) / 6,  m = (S_ab - S_a S_b / L) /
 *     (S_aa - S_a^2 / L),
 * rational wherever the points are. The line between the ends turns with the block, so that the
 * mean plane does too, whatever way the coordinates lie; a plane contact is its own mean plane. */

#ifndef TP_BASE_MEAN_PLANE_H
#define TP_BASE_MEAN_PLANE_H

#include "base/contact.h"

/* The direction (u, v) of a stretch of the outline, and of a contact found on the lattice; false
 * where the ends are one point, which has no direction. */
bool tp_mean_plane_of_outline(fmpq_t u, fmpq_t v, const tp_polyline *outline, long first,
                              long last);
bool tp_mean_plane_of_contact(fmpq_t u, fmpq_t v, const tp_contact *contact,
                              const tp_lattice *lattice);

#endif
