/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks at rest with the strength of their joints over a number, at a tilt: what the proofs of
 * contact_modes are of. */

#ifndef TP_BLOCK_SYSTEM_BLOCKS_AT_H
#define TP_BLOCK_SYSTEM_BLOCKS_AT_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"
#include "contact_modes/resting.h"

/* One state; its arrays are its own. */
typedef struct tp_blocks_at {
  tp_near *friction; /* by contact */
  tp_near *cohesion; /* by contact: the force of all of it, in units of its `along` */
  tp_near *tension;  /* by contact of the assemblage: a pressure; its pull is part of the loads */
  tp_near *bond;     /* 2 a contact: that pull at its ends */
  tp_near *piece;    /* 2 a contact: that of the piece at each end; all of it, where there is one */
  bool has_bond;     /* is any of them not 0? */
  tp_near *loads;    /* w by row, about blocks' own points */
  tp_near *central;  /* and about their centroids */
  bool weights_alone; /* are the loads */
} tp_blocks_at;

TP_MUST_USE bool tp_blocks_at_init(tp_blocks_at *at, const tp_resting *resting);
void tp_blocks_at_clear(tp_blocks_at *at);

void tp_blocks_at_divisor(tp_blocks_at *at, const tp_resting *resting,
                          const tp_built_system *system, double divisor);

/* As the blocks lie. */
TP_MUST_USE tp_status tp_blocks_at_rest(tp_blocks_at *at, const tp_resting *resting,
                                        const tp_resultant *resultant, tp_message *message);

/* At another tilt, in degrees, with earthquake and other loads of the scene; `within`: the
 * resultant lies less than 90 degrees from the normal. Where loads are measured the tilt is
 * rounded. */
TP_MUST_USE tp_status tp_blocks_at_tilt(bool *within, tp_blocks_at *at, const tp_resting *resting,
                                        const tp_resultant *resultant, bool is_measured,
                                        double tilt_deg, tp_message *message);

#endif
