/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety by strength reduction of many blocks as they lie: the greatest number by
 * which tan(phi) of all joints can be divided so that some forces hold them. */

#ifndef TP_BLOCK_SYSTEM_SYSTEM_STRENGTH_H
#define TP_BLOCK_SYSTEM_SYSTEM_STRENGTH_H

#include "block_system/built_system.h"

/* No greater factor is looked for. */
#define TP_MOST_STRENGTH_FACTOR 1000

typedef struct tp_system_strength {
  bool is_held, is_bounded; /* is there a proof below, above? */
  double held, bound;       /* with that factor forces hold the blocks, and with that none do */
  tp_load_bracket collapse; /* with the factor `bound`; empty where there is none */
} tp_system_strength;

/* `tangent` of the angle at which the blocks lie, to the side. TP_OK without proofs where none were
 * found. On failure cleared. */
TP_MUST_USE tp_status tp_system_strength_find(tp_system_strength *strength,
                                              const tp_built_system *system, bool towards_left,
                                              const tp_near *tangent, tp_message *message);
void tp_system_strength_clear(tp_system_strength *strength);

#endif
