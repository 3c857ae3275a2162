/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The geometry of linear virtual motions (contact_modes/virtual_motion.h), in whole numbers.
 *
 * A direction D is chosen along which all blocks could slide together, with the drive. A planar
 * twist has the components (alpha, beta, theta): the velocity alpha D + beta D', D' being D turned
 * by 90 degrees, of a common origin, and the rotation. Every gap and slip is a row of whole numbers
 * on the twist of the first block less that of the second one, so that linear relations among them
 * are exact. */

#ifndef TP_CONTACT_MODES_VIRTUAL_FRAME_H
#define TP_CONTACT_MODES_VIRTUAL_FRAME_H

#include "contact_modes/arranged.h"

#include <flint/fmpz_mat.h>

/* A twist, or what multiplies one. */
typedef struct tp_virtual_row {
  tp_near of[3];
} tp_virtual_row;

typedef struct tp_virtual_block {
  tp_near weight, gyration2; /* about its centroid */
  tp_near along, across;     /* its centroid less the origin: over |D|, times D and D' */
  long near_count, *near;    /* gaps, by number, of contacts among the block and its neighbours */
} tp_virtual_block;

typedef struct tp_virtual_contact {
  long block[2];                 /* by number; -1: fixed */
  bool is_joint;                 /* between free blocks, and a slide along D can open it */
  fmpz gap[2][3], slip[3];       /* exact, times powers of two that all contacts share */
  tp_virtual_row gaps[2], slips; /* the same over the length of n and t */
  tp_virtual_row turn[2];        /* the twist that turns by 1 about an end */
  tp_virtual_row slide;          /* the twist that slips by 1 */
} tp_virtual_contact;

/* Gap number 2 k + e is that of end e of contact k. */
typedef struct tp_virtual_frame {
  const tp_arranged *arranged;
  long block_count, contact_count;
  tp_virtual_block *blocks;
  tp_virtual_contact *contacts;
  fmpz_t direction[2]; /* D, in steps of the lattice */
  int exponent;        /* of the power of two that D is over */
  fmpz_t origin[2];
  tp_near size2; /* |D|^2, of D over its power of two */
} tp_virtual_frame;

/* `exists`: contacts all have two ends, and there is such a direction. `load` is the sum of all. */
TP_MUST_USE tp_status tp_virtual_frame_init(bool *exists, tp_virtual_frame *frame,
                                            const tp_arranged *arranged, const tp_near load[2],
                                            tp_message *message);
void tp_virtual_frame_clear(tp_virtual_frame *frame);

/* The row on the twist of a block about the origin as one about its centroid. */
tp_virtual_row tp_virtual_about_centroid(const tp_virtual_row *row, const tp_virtual_block *block);

tp_near tp_virtual_times(const tp_virtual_row *row, const tp_virtual_row *twist);

/* Gaps near either block of a contact, those first which relations are to be stated in, and what is
 * linear in them: the slip of the contact and the rotation of its first block less that of the
 * second, where they are; and every gap that is, of those before it, as a relation. */
typedef struct tp_virtual_relations {
  long count, *gaps;
  bool has_slip, has_turn;
  tp_near *slip, *turn; /* by gap of these */
  long relation_count;
  tp_near *relations; /* one after another, by gap of these */
} tp_virtual_relations;

TP_MUST_USE bool tp_virtual_relations_init(tp_virtual_relations *relations,
                                           const tp_virtual_frame *frame, long contact);
void tp_virtual_relations_clear(tp_virtual_relations *relations);

#endif
