/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many rigid blocks, some of them fixed, and where they touch.
 *
 * All rings lie on one lattice of whole numbers, so that whether two blocks touch, overlap or leave
 * a gap, however small, is decided exactly. Weights and centroids are enclosed by doubles with
 * their bounds. Lengths are in units of 2^length_exponent lattice steps, about the size of a block,
 * and weights in units of 2^weight_exponent kN per metre of thickness, about that of one. */

#ifndef TP_ASSEMBLAGE_ASSEMBLAGE_H
#define TP_ASSEMBLAGE_ASSEMBLAGE_H

#include "assemblage/given_block.h"
#include "block/ring_sums.h"
#include "number/near.h"
#include "plane/lattice.h"

typedef struct tp_rigid_block {
  long ring;         /* its first one of the lattice */
  long outline, end; /* the points of that: outline … end - 1 */
  long number;       /* among the free ones; -1: it is fixed */
  fmpz_t x, y;       /* the lattice point that its moments are about, next to its centroid */
  tp_near weight;
  tp_near arm_x, arm_y; /* from that point to the centroid */
  tp_near gyration2;    /* moment of inertia about that point over the mass */
} tp_rigid_block;

/* Where two blocks share a piece of an edge; or a corner of one lies on an edge of the other,
 * within it or in a notch at its end, then both ends are that corner. `from` … `to`, two points of
 * the lattice, are that edge, with the first block on the left; forces and motions take their
 * direction from `along`, two more points: the same, or of an edge that is parallel but for
 * roundings (assemblage/straighten.c). */
typedef struct tp_block_contact {
  long block[2], ends[2], from, to, along[2];
} tp_block_contact;

/* Two salient corners that meet, and share no edge there, in one point: each of its two sides is an
 * edge at that point against the corner of the other block, as a contact is. The first side is an
 * edge that ends there, the second one that begins there. One of them is not entered as long as the
 * other is not: the blocks part as soon as either side opens. */
typedef struct tp_corner_pair {
  tp_block_contact side[2];
} tp_corner_pair;

typedef struct tp_assemblage {
  const tp_given_block *given;
  long count, free_count, edge_count; /* edges: of all outlines */
  tp_rigid_block *blocks;
  tp_lattice lattice;
  long length_exponent, weight_exponent;
  long contact_count, contact_room;
  tp_block_contact *contacts;
  long pair_count, pair_room;
  tp_corner_pair *pairs;
} tp_assemblage;

/* On failure `assemblage` is cleared. Bad input: two blocks overlap, a free one touches nothing,
 * none is free or none fixed. */
TP_MUST_USE tp_status tp_assemblage_init(tp_assemblage *assemblage, const tp_given_block *given,
                                         long count, const fmpq_t metres_per_unit,
                                         tp_message *message);
void tp_assemblage_clear(tp_assemblage *assemblage);

/* Of a block, sums of its rings (block/ring_sums.h), each times its weight; and what its weight, in
 * kN per metre of thickness, is to their A2. */
void tp_assemblage_sums(fmpz sums[TP_SUM_COUNT], const tp_assemblage *assemblage, long block);
void tp_assemblage_density(fmpq_t kn, const tp_assemblage *assemblage, long block);

/* A difference of two points of the lattice, or of one and a block's own, as a length. */
tp_near tp_assemblage_length(const tp_assemblage *assemblage, const fmpz_t from, const fmpz_t to);

/* Find the contacts, and the pairs of corners (assemblage/block_contacts.c). */
TP_MUST_USE tp_status tp_block_contacts_find(tp_assemblage *assemblage, tp_message *message);

/* Of blocks whose corners were rounded to about 2^-64 of them all: contacts that are parallel but
 * for that get one direction, exactly (assemblage/straighten.c). */
TP_MUST_USE tp_status tp_assemblage_straighten(tp_assemblage *assemblage, tp_message *message);

#endif
