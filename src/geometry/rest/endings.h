/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ends to which a block comes from its starting positions. Two that rest are of one kind where
 * the same vertices and edges touch: over a stretch of starting positions such a pose shifts and
 * turns with them, since nothing slides, and its contacts stay. */

#ifndef TP_REST_ENDINGS_H
#define TP_REST_ENDINGS_H

#include "rest/settle.h"

typedef struct tp_ending {
  tp_settled how;
  int side;           /* of what rolls off: -1 to the left, 1 to the right; else 0 */
  tp_touches touches; /* of what rests, in order */
} tp_ending;

typedef struct tp_endings {
  long count, capacity;
  tp_ending *items;
} tp_endings;

void tp_endings_clear(tp_endings *endings);

/* The number of the end of what has settled, noted if it is new. */
TP_MUST_USE tp_status tp_endings_note(long *number, tp_endings *endings,
                                      const tp_settling *settling, tp_message *message);

#endif
