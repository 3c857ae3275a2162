/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a contact point of a solid can do at the instant at which the solid is let go, bounded by
 * finitely many vectors of whole numbers.
 *
 * A contact with the normal n and mu = tan(phi) opens, and bears nothing; or sticks, with a force
 * of its cone; or slips along a unit vector s across n, with a force l (n - mu |n| s), l >= 0. The
 * plane across n is divided by rays d_0 .. d_255, of a length of mu |n| to 2^-32. A slip between
 * d_i and d_j has its force in the cone of n - x d_i, n - x d_j, for x = 1 - 2^-28 and 1 + 2^-28,
 * and of n - k (d_i + d_j), k just above 1 / (2 cos^2(half the angle between them)): the arc of all
 * s is between its chord and its tangents. The cone of friction is in that of n + k d_16j for a k
 * just above 1 / cos(pi / 16). Where mu may be as little as a divisor leaves of it, the first two
 * have x over that. So all motions that can begin have their forces in these cones, and more.
 *
 * Nothing is rounded without a bound. Wrenches and rows over twists are taken about the first
 * contact, so that those of forces and rows are whole numbers: points and normals are exact, and
 * rays are rounded, which the margins of 2^-28 cover together with the error of mu. The load, the
 * centroid and the inertia are balls. A vector may have any size, as only its direction counts. */

#ifndef TP_SOLID_CONTACTS_MODE_CONES_H
#define TP_SOLID_CONTACTS_MODE_CONES_H

#include "solid_contacts/hold_load.h"

#include <arb.h>

enum { TP_MODE_RAYS = 256, TP_MODE_POLYGON = 16, TP_MODE_LEVELS = 7, TP_MODE_QUARTERS = 4 };

/* A wrench, or a row over twists, times 2^-exponent; C times that, of loads and rows; doubles. The
 * wrench of a force and a row are exact. */
typedef struct tp_mode_vector {
  bool is_known;
  arb_struct at[TP_WRENCH], turned[TP_WRENCH];
  slong exponent;
  double near[TP_WRENCH], near_turned[TP_WRENCH];
} tp_mode_vector;

/* Forces: by ray within and beyond the arc, of the polygon, of tangents by level and sector. Rows:
 * n, two across, and n x d_j. */
enum {
  TP_MODE_INNER = 0,
  TP_MODE_OUTER = TP_MODE_RAYS,
  TP_MODE_CONE = 2 * TP_MODE_RAYS,
  TP_MODE_TIPS = TP_MODE_CONE + TP_MODE_POLYGON,
  TP_MODE_FORCES = TP_MODE_TIPS + TP_MODE_QUARTERS * ((1 << TP_MODE_LEVELS) - 1),
  TP_MODE_ROW_ACROSS = 1,
  TP_MODE_ROW_RAYS = 3,
  TP_MODE_ROWS = TP_MODE_ROW_RAYS + TP_MODE_RAYS
};

typedef struct tp_mode_contact {
  bool is_smooth; /* mu is 0: its force is along n */
  fmpz at[3], normal[3], across[2][3];
  slong bits; /* rays are in 2^-bits: */
  fmpz rays[TP_MODE_RAYS][3];
  tp_mode_vector forces[TP_MODE_FORCES], rows[TP_MODE_ROWS];
} tp_mode_contact;

/* C is the inverse of the mass matrix: from wrenches to accelerations. */
typedef struct tp_mode_cones {
  long count;
  tp_mode_contact *contacts;
  fmpz unit;                                /* points are whole in lengths of one over that */
  fmpq exact_centroid[3], exact_inertia[6]; /* the centroid from the first contact */
  arb_struct centroid[3], inverse[9];       /* the same, and the inverse of the inertia */
  double divisor;                           /* mu may be anything from that part of it on */
  bool is_in_range; /* else sizes are beyond what doubles hold, and nothing here counts */
  tp_mode_vector loads[2];
  tp_mode_vector change;                     /* along w2 - w1; its doubles are that */
  fmpq exact_loads[3][3], load_errors[3][3]; /* of these at the centroid, of their size */
} tp_mode_cones;

/* Inertia: integrals of x x, y y, z z, y z, z x, x y about the centroid over the mass, in lengths
 * of the cones. `way`: along which the loads differ; NULL where they do not. False when memory is
 * exhausted; cleared then. */
TP_MUST_USE bool tp_mode_cones_init(tp_mode_cones *modes, const tp_friction_cones *cones,
                                    const fmpq inertia[6], double divisor,
                                    const tp_hold_load loads[2], const tp_hold_load *way);
void tp_mode_cones_clear(tp_mode_cones *modes);

/* Which are made as they are asked for. */
const tp_mode_vector *tp_mode_cones_force(tp_mode_cones *modes, long contact, int force);
const tp_mode_vector *tp_mode_cones_row(tp_mode_cones *modes, long contact, int row);
/* The force at the tangents of a sector, of the 4 << level of its level. */
int tp_mode_tip(int level, int sector);

/* Bits to which balls are rounded. */
enum { TP_MODE_BITS = 128 };

/* sum += a . b */
void tp_mode_add_product(arb_t sum, const arb_struct a[TP_WRENCH], const arb_struct b[TP_WRENCH]);
/* C times a wrench. */
void tp_mode_cones_turn(arb_struct turned[TP_WRENCH], const tp_mode_cones *modes,
                        const arb_struct wrench[TP_WRENCH]);

#endif
