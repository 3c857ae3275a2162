/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motion that is told to begin: velocities of blocks, and what each contact does. */

#ifndef TP_BLOCK_SYSTEM_SYSTEM_START_H
#define TP_BLOCK_SYSTEM_SYSTEM_START_H

#include "block_system/moving.h"

/* Of one that was found along the logarithm of the divisor. */
TP_MUST_USE tp_status tp_system_start_set(tp_system_case *own, const tp_moving_search *moving,
                                          tp_message *message);

/* How the blocks begin to move in the motion that was found last. */
TP_MUST_USE tp_status tp_system_start_mechanism(tp_mechanism *mechanism,
                                                const tp_moving_search *moving,
                                                tp_message *message);

#endif
