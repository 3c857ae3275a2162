/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The joint between the underside of a block and its base, open or closed: what water under the
 * block fills. A block on a profile touches it in a few places, and the joint goes on beyond the
 * outermost of them as far as its underside (problem/sole.h) has base below it. */

#ifndef TP_PROBLEM_BASE_JOINT_H
#define TP_PROBLEM_BASE_JOINT_H

#include "base/contact.h"
#include "problem/sole.h"

/* Where it ends, in metres of the scene: to the left [0], to the right [1]. And its outermost
 * contacts: what lies between one of them and the end on its side is an open gap. */
typedef struct tp_base_joint {
  fmpq x[2], y[2];
  long vertex[2]; /* of the outline; -1: inside an edge of it */
  fmpq contact_x[2], contact_y[2];
  long contact_vertex[2]; /* likewise */
} tp_base_joint;

/* Is there an open gap between the end on that side and the outermost contact? */
bool tp_base_joint_gapes(const tp_base_joint *joint, int side);

void tp_base_joint_init(tp_base_joint *joint);
void tp_base_joint_clear(tp_base_joint *joint);

/* Of a contact, its underside (count 0: none is told, and the contact is all) and the profile's
 * first and last point on the lattice. */
void tp_base_joint_find(tp_base_joint *joint, const tp_contact *contact, const tp_sole *sole,
                        const tp_lattice *lattice, const long base_ends[2]);

#endif
