/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks at rest in contact, as Newton's law sees them at the instant at which they are let go:
 *
 *     M a = w + sum over ends of contacts (N n + T t),  u = (n . a, t . a)
 *
 * with accelerations a over gravity, and at each end N, u_n >= 0, N u_n = 0; |T| <= N tan(phi), and
 * T = -N tan(phi) against the slip where u_t is not 0. All in the units of the assemblage, rows as
 * of its program of forces: three a block, about the block's own point. */

#ifndef TP_CONTACT_MODES_RESTING_H
#define TP_CONTACT_MODES_RESTING_H

#include "assemblage/force_program.h"

/* n at each end, t; of the same size. Along t both ends of a contact move alike. Where an edge is
 * in pieces, all that the same two blocks share along a line, with one friction, is one contact:
 * what its outer ends can do, and bear, says it of all between. A pair of corners is two contacts
 * of one end, its sides, behind all others (contact_modes/corner_modes.h). */
typedef struct tp_resting_contact {
  int ends; /* 1: a corner */
  tp_force_column normal[2], along;
  tp_block_contact of; /* from end to end, as those of the assemblage are */
  long line;           /* the first contact of the same two blocks along the same line */
  long twin;           /* of a pair of corners the other side; -1: it is of none */
} tp_resting_contact;

/* A contact of the assemblage: which of these it is part of; its length over the size of that one's
 * columns, of a corner nothing; and how a force at its middle is shared by the ends of that one. */
typedef struct tp_resting_piece {
  long contact;
  tp_near length, share[2];
} tp_resting_piece;

typedef struct tp_resting {
  const tp_assemblage *assemblage;
  long rows, contact_count;
  long pair_first;     /* the first contact that is of a pair of corners; they follow each other */
  long *block;         /* by number of a free block: which it is */
  bool slips_run_back; /* slips are counted against `of.along` (contact_modes/arranged.h) */
  tp_resting_contact *contacts;
  tp_resting_piece *pieces; /* by contact of the assemblage */
} tp_resting;

/* `strengths` by contact of the assemblage. On failure cleared. */
TP_MUST_USE tp_status tp_resting_init(tp_resting *resting, const tp_assemblage *assemblage,
                                      const tp_contact_strength *strengths, tp_message *message);
void tp_resting_clear(tp_resting *resting);

/* w by row, of loads with so much of the live one, and of the pull of all that is `tension`, by
 * contact of the assemblage: what bears so much less at each end may pull by that; its moments
 * about blocks' own points, and in `central` about their centroids, where weights have none; and
 * whether there is nothing but weights. */
TP_MUST_USE tp_status tp_resting_loads(tp_near *rows, tp_near *central, bool *weights_alone,
                                       const tp_resting *resting, const tp_weight_loads *loads,
                                       tp_near live, const tp_near *tension, tp_message *message);

/* M^-1 of a wrench on a block; in doubles too. */
void tp_resting_accelerate(tp_near own[3], const tp_rigid_block *block, const tp_near wrench[3]);
void tp_resting_accelerate_double(double own[3], const tp_rigid_block *block,
                                  const double wrench[3]);

/* What a row of a contact gives of accelerations by row; in doubles too. */
tp_near tp_resting_along(const tp_force_column *column, const tp_near *rows);
double tp_resting_along_double(const tp_force_column *column, const double *rows);

#endif
