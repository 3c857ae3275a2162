/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings whose edges meet by less than the last digit of their coordinates. */

#ifndef TP_BLOCK_REPAIR_H
#define TP_BLOCK_REPAIR_H

#include "common/notes.h"
#include "plane/polyline.h"

/* What a repair did, or would do. */
typedef struct tp_repair {
  bool done;    /* no edge meets another any more; false: the ring is as it was */
  long moved;   /* vertices, none where no edges met */
  double most;  /* the greatest move, in scene lengths */
  fmpq_t digit; /* the last digit: every coordinate is a multiple of it */
} tp_repair;

void tp_repair_init(tp_repair *repair);
void tp_repair_clear(tp_repair *repair);

/* Move vertices of a closed ring, each by less than the last digit, until none of its edges meet.
 * `repair` is initialised. */
TP_MUST_USE tp_status tp_repair_ring(tp_polyline *ring, tp_repair *repair, tp_message *message);

/* The same where a scene asks for it, with a note on what was moved where something was. */
TP_MUST_USE tp_status tp_repair_with_notes(tp_polyline *ring, const char *name, tp_notes *notes,
                                           tp_message *message);

/* What to do about a ring that meets itself: the repair, if it would help and the ring can have it,
 * or the vertices by hand. */
TP_MUST_USE tp_status tp_repair_advice(char *advice, size_t size, const tp_polyline *ring,
                                       bool repairable, tp_message *message);

#endif
