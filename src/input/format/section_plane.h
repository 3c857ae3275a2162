/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The upright plane of a section, with its own coordinates: s along it from a point of the map, and
 * the height.
 *
 * Of two points of the map the plane is exact, and s is off by less than 1e-18 of itself where
 * their distance is no fraction, else exact. Of a point and an azimuth (clockwise from y, as a
 * bearing from north) the direction is the point (2 t, 1 - t^2)/(1 + t^2) of the unit circle
 * nearest to it for t of 40 binary digits, whose azimuth is within 1e-12 rad of what is asked: a
 * millionth of a millimetre in a kilometre. Then s is exact along that plane; multiples of 90
 * degrees are exact. */

#ifndef TP_FORMAT_SECTION_PLANE_H
#define TP_FORMAT_SECTION_PLANE_H

#include "common/message.h"

#include <flint/fmpq.h>

typedef struct tp_section_plane {
  fmpq x, y;    /* where s is zero */
  fmpq dx, dy;  /* along s */
  fmpq scale;   /* s of a step dx, dy by dx^2 + dy^2 */
  bool y_is_up; /* the map is x and -z of the mesh, the height its y; else x, y and z */
} tp_section_plane;

void tp_section_plane_init(tp_section_plane *plane);
void tp_section_plane_clear(tp_section_plane *plane);

/* From the first point towards the second; false where they are one. */
TP_MUST_USE bool tp_section_plane_through(tp_section_plane *plane, const fmpq_t x0, const fmpq_t y0,
                                          const fmpq_t x1, const fmpq_t y1);
void tp_section_plane_at(tp_section_plane *plane, const fmpq_t x, const fmpq_t y,
                         const fmpq_t azimuth_deg);

/* Of a vertex: on which side of the plane it lies, above zero to the left of s; and s and height of
 * one on it. */
int tp_section_plane_side(const tp_section_plane *plane, const fmpq vertex[3]);
void tp_section_plane_across(fmpq_t across, const tp_section_plane *plane, const fmpq vertex[3]);
void tp_section_plane_along(fmpq_t along, fmpq_t height, const tp_section_plane *plane,
                            const fmpq vertex[3]);

#endif
