/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How blocks begin to move at a limit, and the forces between them just before it: what the two
 * proofs of a bracket hold, as numbers of a result. Doubles without bounds: the proofs are of the
 * limit, which many a force and some a motion share. */

#ifndef TP_BLOCK_SYSTEM_COLLAPSE_H
#define TP_BLOCK_SYSTEM_COLLAPSE_H

#include "block_system/threshold.h"

/* Into the motions and forces of a case, which have their room; the bracket is one of the state.
 * `scale`: of forces, what a load of one is to the weights. */
TP_MUST_USE tp_status tp_collapse_describe(tp_system_case *own, const tp_built_system *system,
                                           const tp_load_bracket *bracket,
                                           const tp_system_state *state, double scale,
                                           tp_message *message);

/* How each block moves by velocities run against, by row: three a free block. */
TP_MUST_USE tp_status tp_collapse_motions(tp_system_motion *motions,
                                          const tp_assemblage *assemblage, const double *twists,
                                          tp_message *message);

#endif
