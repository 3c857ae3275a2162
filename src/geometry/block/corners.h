/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rounded corners (docs/mechanics.md section 4; Appendix B of the paper).
 *
 * A convex vertex with interior angle theta and radius r loses its tip: the tangent points lie at
 * l = r / tan(theta / 2) from it along both edges. Model `exact` takes off the area between the
 * kite of vertex, tangent points and centre and the sector about the centre, l r - r^2 (pi - theta)
 * / 2; model `paper` keeps the mass. */

#ifndef TP_BLOCK_CORNERS_H
#define TP_BLOCK_CORNERS_H

#include "block/moments.h"
#include "block/region.h"

typedef struct tp_corner {
  tp_place radius_place;      /* where the scene gives its radius */
  long vertex, before, after; /* points of the lattice: the vertex and its neighbours */
  fmpq_t radius;              /* lattice units */
} tp_corner;

typedef struct tp_corners {
  long count; /* of radius above zero */
  bool keeps_mass;
  tp_corner *items; /* in the order of their vertices */
} tp_corners;

/* The scene's rounded corners on the outline, the first chain of the lattice. `ends`: the vertices
 * where the contact ends, left and right; NULL: its base has a profile, and the ends meant are
 * those of the underside, the leftmost and the rightmost vertex. Reflex corners, radii that do not
 * fit their edges, roundings that overlap, and arcs that a hole or another part of the outline
 * reaches across are bad input. On failure `corners` is cleared. */
TP_MUST_USE tp_status tp_corners_init(tp_corners *corners, const tp_block_description *block,
                                      const long ends[2], const tp_section *section,
                                      const tp_lattice *lattice, const fmpq_t metres_per_unit,
                                      tp_message *message);
void tp_corners_clear(tp_corners *corners);

/* A corner in lattice units: tangent points on the edges before and after the vertex, the centre of
 * curvature, and l. */
typedef struct tp_corner_ball {
  tp_ball_point before, after, centre;
  arb_t length, radius, half_tangent; /* tan(theta / 2) */
} tp_corner_ball;

void tp_corner_ball_init(tp_corner_ball *ball);
void tp_corner_ball_clear(tp_corner_ball *ball);
void tp_corner_evaluate(tp_corner_ball *ball, const tp_corner *corner, const tp_lattice *lattice,
                        long bits);

/* Take the tips off the moments, where the model does. */
void tp_corners_take_off(tp_moments *moments, const tp_corners *corners, const tp_section *section,
                         const tp_lattice *lattice, long bits);

/* A tip of an arc likewise (its radius, not its length), and all of them off the moments. */
void tp_arc_tip_evaluate(tp_corner_ball *ball, const tp_arc_tip *tip, const tp_lattice *lattice,
                         const fmpq_t metres_per_unit, long bits);
void tp_arcs_take_off(tp_moments *moments, const tp_section *section, const tp_lattice *lattice,
                      const fmpq_t metres_per_unit, long bits);

/* Refuse parts, and holes that reach into a tip of an arc. */
TP_MUST_USE tp_status tp_arcs_check(const tp_section *section, const tp_lattice *lattice,
                                    const tp_block_description *block, const fmpq_t metres_per_unit,
                                    tp_message *message);

/* The corner at a vertex of the outline, by its point of the lattice, or NULL. */
const tp_corner *tp_corners_at(const tp_corners *corners, long vertex);

#endif
