/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A claim that in a set of modes no motion gains on a load, and its proof.
 *
 * The claim names rows that the motions a satisfy, forces that they have, and basic forces, of
 * which there are as many as unknown rows. With y = C (w + sum of z row), the z of priced rows
 * given and those of unknown rows such that y . f = 0 for each basic force f, it is proven where
 *
 *     z >= 0 for each row n . a >= 0,  y . f <= 0 for each force f,  y . w1 <= 0,  y . w2 <= 0
 *
 * for the true body and loads: then w . a = y . M a - sum of z row . a <= y . (w' + sum of f) <= 0
 * for w' = w1, w2 and all between them (solid_exclusion.h). As y . f = 0 defines z, it holds for
 * the true body exactly. Six basic forces leave y = 0 alone, as they are independent.
 *
 * First in balls, of which the signs must be certain. What symmetry makes exactly zero has no sign
 * in balls, and is proven in rational numbers: points, normals, rays, centroid and inertia are
 * exact, and z is a linear function of the three components of the load, z = Z w + z0, of which Z
 * and z0 are exact. A sign is then that of a linear function, or of a quadratic one, over the
 * bounds of these components; a component without error, such as 0 across a plane of symmetry, has
 * none. */

#ifndef TP_SOLID_CONTACTS_MODE_CLAIM_H
#define TP_SOLID_CONTACTS_MODE_CLAIM_H

#include "solid_contacts/mode_cones.h"

enum { TP_MODE_CONTACTS = 16, TP_MODE_CLAIM_ROWS = 3 * TP_MODE_CONTACTS };

typedef struct tp_mode_claim_row {
  const tp_mode_vector *vector;
  int sign; /* of the z: 1 not below zero, -1 not above, 0 any */
} tp_mode_claim_row;

typedef struct tp_mode_claim {
  const tp_mode_cones *modes;
  int target; /* w is the load w1 or w2 */
  long unknown_count;
  tp_mode_claim_row unknown[TP_MODE_CLAIM_ROWS];
  long priced_count; /* rows with a z of plus or minus 2^price_bits, as they may have */
  tp_mode_claim_row priced[TP_MODE_CLAIM_ROWS];
  int price_bits;
  long basic_count;
  const tp_mode_vector *basic[TP_MODE_CLAIM_ROWS + 1];
  const tp_mode_vector *change; /* w2 - w1, where it is the last of the basic forces; else NULL */
  long force_count;
  const tp_mode_vector *const *forces;
} tp_mode_claim;

/* In balls. Where not: may what failed be zero? */
bool tp_mode_claim_holds(bool *is_close, const tp_mode_claim *claim);

/* The rank of rows or forces, which are exact. */
long tp_mode_rank(const tp_mode_vector *const *vectors, long count);

/* In rational numbers (mode_claim_exact.c). */
bool tp_mode_claim_holds_exactly(const tp_mode_claim *claim);
bool tp_mode_claim_has_basic(const tp_mode_claim *claim, const tp_mode_vector *force);

#endif
