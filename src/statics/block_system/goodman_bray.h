/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Limit equilibrium of columns in a row by Goodman and Bray (1976), beside the free limit. */

#ifndef TP_BLOCK_SYSTEM_GOODMAN_BRAY_H
#define TP_BLOCK_SYSTEM_GOODMAN_BRAY_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"

/* `own` is zero before. What it is given is given back by tp_block_system_free, also after a
 * failure. `weighed`: the scene gives unit weights. */
TP_MUST_USE tp_status tp_goodman_bray_find(tp_goodman_bray *own, const tp_built_system *system,
                                           const tp_resultant *resultant, bool weighed,
                                           tp_message *message);

/* The force to design for by that method, where the scene asks for a support of the toe and the
 * method applies: into the support of a case that has both already. */
TP_MUST_USE tp_status tp_goodman_bray_support(tp_system_case *own, const tp_built_system *system,
                                              const tp_resultant *resultant, tp_message *message);

#endif
