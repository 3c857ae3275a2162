/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks at rest in an order that does not depend on how they were listed, nor on which side they
 * are driven to: what a search finds within its work is then the same of a pile, of its mirror
 * image that goes to the other side, and of both with their blocks in any order. Blocks are ordered
 * from the ground on, then along the drive; contacts by their blocks; of a pile that goes to the
 * left x runs to the left. All moments are about centroids, and n and t of size one. */

#ifndef TP_CONTACT_MODES_ARRANGED_H
#define TP_CONTACT_MODES_ARRANGED_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

typedef struct tp_arranged {
  tp_resting resting; /* as it is arranged */
  const tp_resting *given;
  bool mirrored;            /* x runs to the left */
  tp_assemblage assemblage; /* that given, but for its blocks */
  tp_rigid_block *blocks;
  long *rank;    /* by block of the assemblage, fixed ones as well */
  long *level;   /* of the same, how many contacts lie between it and the ground at least */
  long *number;  /* by number of a free block: which it is as given */
  long *contact; /* by contact: which it is as given */
  bool *swapped; /* by contact: its first end is the second one as given */
  double *size;  /* by contact: that of n and t as given, over which they are divided here */
} tp_arranged;

TP_MUST_USE tp_status tp_arranged_init(tp_arranged *arranged, const tp_resting *given,
                                       bool to_the_left, tp_message *message);
void tp_arranged_clear(tp_arranged *arranged);

/* Tangents by contact; forces by contact, along t; normal forces, 2 a contact by its ends; loads by
 * row, given about centroids. */
void tp_arranged_friction(tp_near *own, const tp_arranged *arranged, const tp_near *given);
void tp_arranged_cohesion(tp_near *own, const tp_arranged *arranged, const tp_near *given);
void tp_arranged_bonds(tp_near *bonds, const tp_arranged *arranged, const tp_near *given);
void tp_arranged_loads(tp_near *own, const tp_arranged *arranged, const tp_near *given);

/* One mode a contact, of a pair of corners of one of its sides, as it was given. */
void tp_arranged_modes(tp_mode_set *given, const tp_arranged *arranged, const tp_mode_set *own);

#endif
