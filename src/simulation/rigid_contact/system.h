/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A body on its base under a drive, in numbers without dimension: lengths over the extent of the
 * block, times over sqrt(extent / gravity), forces over the weight. */

#ifndef TP_RIGID_CONTACT_SYSTEM_H
#define TP_RIGID_CONTACT_SYSTEM_H

#include "rigid_body/drive.h"
#include "rigid_contact/gap.h"

/* A gap no wider than this is closed: far above the rounding of places (1e-16), far below what
 * anything else of a scene means. The height of such a fall is its part of the energy. */
#define TP_CLOSED_GAP 1e-12

/* How far a closed contact may lie in the rock: some times what it takes to be found to press. */
#define TP_DEEPEST_GAP 1e-10

/* A speed no larger than this is none. */
#define TP_NO_SPEED 1e-10

typedef struct tp_contact_system {
  const tp_rigid_body *body;
  const tp_drive *drive;
  double time_unit_s;
  double inertia[3]; /* 1, 1, the radius of gyration squared */
  tp_contact_shapes shapes;
  double base_left, base_right;
  long pair_count, pair_room;
  tp_gap_pair *pairs; /* that can close before the block has moved by the reach from where it was */
  tp_motion_state listed_at;
  long near_count; /* of them, by number: those that can close before the block has moved by */
  long *near;      /* `near_reach` from `near_at`, and those that touch; -1: not asked yet */
  double near_reach;
  tp_motion_state near_at;
  bool too_many; /* pairs; told of a system that could not be set up (budget.h) */
} tp_contact_system;

/* False when memory is exhausted: then it is cleared. */
TP_MUST_USE bool tp_contact_system_init(tp_contact_system *system, const tp_rigid_body *body,
                                        const tp_drive *drive, const tp_body_state *start);
void tp_contact_system_clear(tp_contact_system *system);

/* Lists the pairs anew where the block has moved so far that others could close; which of them
 * touch stays as it was. False when memory is exhausted. */
TP_MUST_USE bool tp_contact_system_list(tp_contact_system *system, const tp_motion_state *state);

/* Has the block moved so little since the pairs were listed that no other can have closed? */
bool tp_contact_system_covers(const tp_contact_system *system, const tp_motion_state *state);

/* Sees to it that `near` has all pairs that can close before the block has moved by a distance, or
 * turned by as much, or both by parts of it. */
void tp_contact_system_near(tp_contact_system *system, const tp_motion_state *state,
                            double distance);

tp_motion_state tp_motion_of(const tp_contact_system *system, const tp_body_state *state);
tp_body_state tp_motion_told(const tp_contact_system *system, const tp_motion_state *state);

/* The acceleration without contacts. */
void tp_contact_system_free(double free[3], const tp_contact_system *system, double time);

double tp_motion_energy(const tp_contact_system *system, const double speed[3]);

/* tan(phi) at a contact, and the facet of the base that it lies on: where a corner of the base
 * touches, of the edge whose normal is nearer to that of the contact; of two as near, the less
 * rough.
 */
double tp_contact_friction(long *facet, const tp_contact_system *system, const tp_gap *gap);

/* By how much the block is still above the base. */
double tp_contact_system_overlap(const tp_contact_system *system, const tp_motion_state *state);

#endif
