/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The steps of a repair (mend.h). All but the merging of near points leave every point where it is,
 * and none adds one. */

#ifndef TP_SOLID_MEND_STEPS_H
#define TP_SOLID_MEND_STEPS_H

#include "solid/mending.h"

/* All are false when memory is exhausted. */

/* A point within `within` of one that stays becomes that one; triangles that lose a corner go. */
TP_MUST_USE bool tp_mending_merge(tp_mending *m, double within);

/* Of triangles between the same points one stays. */
TP_MUST_USE bool tp_mending_drop_duplicates(tp_mending *m);

/* Pieces of less than this share of all area go. */
TP_MUST_USE bool tp_mending_drop_pieces(tp_mending *m, double share);

/* Neighbours pass their edge in opposite directions, by turning the fewer of each piece;
 * `*one_sided` where a piece cannot be. */
TP_MUST_USE bool tp_mending_orient(tp_mending *m, bool *one_sided);

/* Loops of edges with one triangle are closed by triangles between their points. */
TP_MUST_USE bool tp_mending_close(tp_mending *m);

/* A triangle whose corners lie on one line parts its neighbour at the long side, and goes. */
TP_MUST_USE bool tp_mending_part_flat(tp_mending *m);

/* Outwards: all are turned where the volume is below zero. What gaps have of area and volume. */
void tp_mending_measure(tp_mending *m);

#endif
