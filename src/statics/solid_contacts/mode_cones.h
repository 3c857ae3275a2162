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
 * Wrenches and rows over twists are taken about the first contact, so that their numbers are those
 * of the scene. A vector may be of any size, as only its direction counts. Points and normals are
 * exact; mu, the centroid, the inertia and the load are rounded, by 2^-50 of themselves or less. */

#ifndef TP_SOLID_CONTACTS_MODE_CONES_H
#define TP_SOLID_CONTACTS_MODE_CONES_H

#include "solid_contacts/hold_load.h"
#include "solid_contacts/solid_section.h"

enum { TP_MODE_RAYS = 256, TP_MODE_POLYGON = 16, TP_MODE_LEVELS = 7, TP_MODE_QUARTERS = 4 };

/* A wrench, or a row over twists; C times it; and doubles that are 2^-exponent of both. */
typedef struct tp_mode_vector {
  bool is_known;
  fmpz whole[TP_WRENCH], turned[TP_WRENCH];
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
  fmpz unit;        /* points are whole in lengths of one over that */
  fmpz centroid[3]; /* from the first contact, in 2^-centroid_bits of a length */
  fmpz inverse[9];  /* of the inertia, in 2^-inverse_bits */
  slong centroid_bits, inverse_bits;
  double divisor;   /* mu may be anything from that part of it on */
  bool is_in_range; /* else sizes are beyond what doubles hold, and nothing here counts */
  tp_mode_vector loads[2];
} tp_mode_cones;

/* False when memory is exhausted; cleared then. */
TP_MUST_USE bool tp_mode_cones_init(tp_mode_cones *modes, const tp_friction_cones *cones,
                                    const tp_solid_section_inertia *inertia, double divisor,
                                    const tp_hold_load loads[2]);
void tp_mode_cones_clear(tp_mode_cones *modes);

/* Which are made as they are asked for. */
const tp_mode_vector *tp_mode_cones_force(tp_mode_cones *modes, long contact, int force);
const tp_mode_vector *tp_mode_cones_row(tp_mode_cones *modes, long contact, int row);
/* The force at the tangents of a sector, of the 4 << level of its level. */
int tp_mode_tip(int level, int sector);

/* sum += a . b */
void tp_mode_add_product(fmpz_t sum, const fmpz a[TP_WRENCH], const fmpz b[TP_WRENCH]);

#endif
