/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One solution of Newton's and Coulomb's laws for blocks at rest that are let go (contact_modes/
 * resting.h), in doubles: end after end is given the force that its law asks for while the others
 * keep theirs, round after round (the Gauss-Seidel method of Jean, 1999). Which of several
 * solutions it ends in depends on the forces that it begins with: nothing here is certain, and a
 * motion that it ends in is what contact_modes/beginning.h proves. */

#ifndef TP_CONTACT_MODES_LETTING_GO_H
#define TP_CONTACT_MODES_LETTING_GO_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

/* Which side of a pair of corners bears. Where it is asked for, it does so before ends of contacts
 * in its point. */
typedef enum tp_letting_go_corners {
  TP_CORNERS_AS_THEY_OPEN,
  TP_CORNERS_FIRST_SIDE,
  TP_CORNERS_SECOND_SIDE
} tp_letting_go_corners;

typedef struct tp_letting_go {
  const tp_resting *resting;
  double *accelerations;    /* by row */
  double *normals, *shears; /* 2 a contact */
  bool backwards;           /* rounds run from the last contact to the first */
  tp_letting_go_corners corners;
  double most; /* the largest velocity of an end against the other block */
} tp_letting_go;

TP_MUST_USE tp_status tp_letting_go_init(tp_letting_go *letting_go, const tp_resting *resting,
                                         tp_message *message);
void tp_letting_go_clear(tp_letting_go *letting_go);

/* No forces. */
void tp_letting_go_release(tp_letting_go *letting_go);

/* The forces of another. */
void tp_letting_go_copy(tp_letting_go *own, const tp_letting_go *from);

/* What contacts bear besides normal forces. */
typedef struct tp_shear_strength {
  const tp_near *friction; /* tan(phi), by contact */
  const tp_near *cohesion; /* the force of all of it, by contact */
  const tp_near *bond;     /* 2 a contact: the pull at its ends, which is part of the loads */
} tp_shear_strength;

/* From its forces on; without strength where that is NULL; `loads` w by row. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_letting_go_find(tp_letting_go *letting_go, const tp_shear_strength *strength,
                                    const tp_near *loads, long rounds);

/* One mode a contact, as it moves. */
void tp_letting_go_modes(tp_mode_set *modes, const tp_letting_go *letting_go,
                         const tp_shear_strength *strength);

/* Does anything move? */
bool tp_letting_go_moves(const tp_letting_go *letting_go);

#endif
