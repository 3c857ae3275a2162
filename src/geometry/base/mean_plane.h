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

typedef struct tp_mean_plane {
  fmpq_t along[2];             /* the line between the ends */
  fmpq_t length, a, b, aa, ab; /* L, 2 S_a, 2 S_b, 6 S_aa, 6 S_ab: whole where the points are */
} tp_mean_plane;

void tp_mean_plane_init(tp_mean_plane *plane);
void tp_mean_plane_clear(tp_mean_plane *plane);

/* Begin with the ends, add the facets, and find the direction (u, v); false where the ends are one
 * point, which has no direction. All points are relative to the first end. */
void tp_mean_plane_ends(tp_mean_plane *plane, const fmpq_t dx, const fmpq_t dy);
void tp_mean_plane_add(tp_mean_plane *plane, const fmpq_t x0, const fmpq_t y0, const fmpq_t x1,
                       const fmpq_t y1);
bool tp_mean_plane_direction(fmpq_t u, fmpq_t v, const tp_mean_plane *plane);

/* Of a stretch of the outline, and of a contact found on the lattice. */
bool tp_mean_plane_of_outline(fmpq_t u, fmpq_t v, const tp_polyline *outline, long first,
                              long last);
bool tp_mean_plane_of_contact(fmpq_t u, fmpq_t v, const tp_contact *contact,
                              const tp_lattice *lattice);

#endif
