/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a ring a simple polygon? */

#ifndef TP_BLOCK_CHECK_RING_H
#define TP_BLOCK_CHECK_RING_H

#include "common/message.h"
#include "plane/lattice.h"

/* Refuse a closed ring with a vertex given twice in a row, all vertices on a line, or one that
 * meets itself. `name` is the ring in the message, which offers a repair where it is `repairable`
 * and that would help. */
TP_MUST_USE tp_status tp_check_ring(const tp_polyline *ring, const tp_lattice *lattice, long chain,
                                    bool repairable, const char *name, tp_message *message);

#endif
