/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene whose outline has chords in place of its arcs, where it gives an `arc_tolerance`: a block
 * with straight edges, for all that takes these alone. */

#ifndef TP_PROBLEM_CHORDED_H
#define TP_PROBLEM_CHORDED_H

#include "block/arc_chords.h"
#include "common/notes.h"

typedef struct tp_chorded {
  tp_scene scene; /* shares with the scene all but its outline */
  tp_arc_chords chords;
} tp_chorded;

/* Stays NULL where the scene does not ask for it, or has no arcs; else a note says how far the
 * chords leave them. On failure it stays NULL. */
TP_MUST_USE tp_status tp_chorded_init(tp_chorded **chorded, const tp_scene *scene, tp_notes *notes,
                                      tp_message *message);
void tp_chorded_free(tp_chorded *chorded);

#endif
