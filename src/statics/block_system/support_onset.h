/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From which force of a support on no motion of many blocks can begin.
 *
 * Limit analysis has a lesser force: with it some forces hold the blocks, but nothing makes sure
 * that they are there. Here the force P runs along a line of loads. A first P is looked for at
 * which all motions are excluded (contact_modes/exclusion.h); from there on they are excluded
 * downwards, as far as that is proven, and upwards; motions are proven from below
 * (block_system/moving.h). Both ends are proofs, and what is between them is open. A greater force
 * than the upper one may push the blocks up. */

#ifndef TP_BLOCK_SYSTEM_SUPPORT_ONSET_H
#define TP_BLOCK_SYSTEM_SUPPORT_ONSET_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"

/* Forces in those of the assemblage. */
typedef struct tp_support_task {
  const tp_built_system *system;
  const tp_resultant *resultant;
  tp_weight_loads loads; /* the live load is a force of one */
  double divisor;        /* of strength */
  double fails;          /* below that no forces hold the blocks; 0: they hold them without */
  double held, most;     /* forces hold them with the former, and with the latter */
  double by_method;      /* a force that may be enough; or 0 */
  double newtons;        /* per metre, of a force of one */
} tp_support_task;

/* Into the support. Nothing where there are too many blocks, or nothing is proven. */
TP_MUST_USE tp_status tp_support_onset_find(tp_system_support *support, const tp_support_task *task,
                                            tp_message *message);

#endif
