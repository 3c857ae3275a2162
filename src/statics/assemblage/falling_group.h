/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks that fall though all others are fixed, as those that hang beyond the end of their ground.
 * They prove that no forces hold the whole, in microseconds a block, where a program of thousands
 * of blocks that has no solution takes minutes, and ends without a proof. */

#ifndef TP_ASSEMBLAGE_FALLING_GROUP_H
#define TP_ASSEMBLAGE_FALLING_GROUP_H

#include "assemblage/force_program.h"

/* `*falls`: it is proven that no forces of the program hold this load, by one block or by several
 * that move as one body. False says nothing. */
TP_MUST_USE tp_status tp_falling_group_find(bool *falls, const tp_force_program *program,
                                            tp_near load, tp_message *message);

#endif
