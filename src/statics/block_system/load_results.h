/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads on blocks, and the support that they need, as results of a case. */

#ifndef TP_BLOCK_SYSTEM_LOAD_RESULTS_H
#define TP_BLOCK_SYSTEM_LOAD_RESULTS_H

#include "block_system/built_system.h"
#include "block_system/resultant.h"

/* The loads of a case, at its tilt. What it is given is given back by tp_block_system_free, also
 * after a failure. */
TP_MUST_USE tp_status tp_load_results_set(tp_system_case *own, const tp_built_system *system,
                                          const tp_resultant *resultant, tp_message *message);

/* The support that the scene asks for (block_system/support.c); nothing where it asks for none. */
TP_MUST_USE tp_status tp_support_find(tp_system_case *own, const tp_built_system *system,
                                      const tp_resultant *resultant, tp_message *message);

/* And from which force on no motion can begin (block_system/support_onset.h), where it was found;
 * by then the force of Goodman and Bray's method is known, where it applies. */
TP_MUST_USE tp_status tp_support_onset(tp_system_case *own, const tp_built_system *system,
                                       const tp_resultant *resultant, tp_message *message);

#endif
