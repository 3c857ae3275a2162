/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The accelerations that modes allow, exactly. Blocks that stick to each other by edges are one
 * group, of which the accelerations are three numbers about the point of its first block; ends that
 * stay closed and contacts that stick are rows on these, in whole numbers: steps of the lattice. */

#ifndef TP_CONTACT_MODES_RIGID_GROUPS_H
#define TP_CONTACT_MODES_RIGID_GROUPS_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

#include <flint/fmpz_mat.h>

typedef struct tp_rigid_groups {
  const tp_resting *resting;
  long count;      /* without the one that is at rest with the ground */
  long *group;     /* by block: its group; -1: at rest */
  long *first;     /* by group: its first block */
  fmpz_mat_t free; /* 3 count x freedom: the accelerations that are allowed */
  long freedom;
  long *scale;        /* by free acceleration: bits of its largest number, so much of a block */
  tp_mode_set *modes; /* by contact: that all this is of; all 0: of none yet */
} tp_rigid_groups;

/* Of no modes yet. On failure cleared. */
TP_MUST_USE tp_status tp_rigid_groups_init(tp_rigid_groups *groups, const tp_resting *resting,
                                           tp_message *message);
void tp_rigid_groups_clear(tp_rigid_groups *groups);

/* Of these modes, one a contact: nothing to do where they are those of the last time. */
TP_MUST_USE tp_status tp_rigid_groups_find(tp_rigid_groups *groups, const tp_mode_set *modes,
                                           tp_message *message);

/* The row of n at an end, or of t (`along`), on the free accelerations: freedom numbers. */
void tp_rigid_groups_row(fmpz *row, const tp_rigid_groups *groups, long contact, int end,
                         bool along);

/* An acceleration of a block, 0, 1 or its turn for a step of the lattice, in one of them. */
void tp_rigid_groups_acceleration(fmpz_t own, const tp_rigid_groups *groups, long block, int axis,
                                  long freedom);

#endif
