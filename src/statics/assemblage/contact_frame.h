/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A contact's direction and ends, and forces there as rows of the two blocks. */

#ifndef TP_ASSEMBLAGE_CONTACT_FRAME_H
#define TP_ASSEMBLAGE_CONTACT_FRAME_H

#include "assemblage/assemblage.h"

/* A force of about size one. Of a fixed block the row is -1, and its entries nothing. */
typedef struct tp_force_column {
  long contact, row[2];
  tp_near most; /* the greatest factor on it; an infinity: there is none */
  tp_near entry[2][3];
} tp_force_column;

/* The direction over a power of two, so that its size is about one; and the length of the contact
 * over that size. */
typedef struct tp_contact_frame {
  tp_near dx, dy, length;
  int exponent; /* of that power */
  long ends[2]; /* points of the lattice */
} tp_contact_frame;

/* So that its cone of friction, with such a tangent, is of size one; of a contact of the
 * assemblage, and of any that is as those are. */
tp_contact_frame tp_contact_frame_between(const tp_assemblage *assemblage,
                                          const tp_block_contact *contact, tp_near tangent);
tp_contact_frame tp_contact_frame_of(const tp_assemblage *assemblage, long contact,
                                     tp_near tangent);

/* A force of the first two of `force` at an end, on the block to the left; on the other one turned
 * round. Of a contact of the assemblage; and of any that is as those are, which has no number. */
void tp_contact_frame_column(tp_force_column *column, const tp_assemblage *assemblage, long contact,
                             const tp_contact_frame *frame, int end, const tp_near force[2]);
void tp_contact_frame_column_between(tp_force_column *column, const tp_assemblage *assemblage,
                                     const tp_block_contact *contact, const tp_contact_frame *frame,
                                     int end, const tp_near force[2]);

#endif
