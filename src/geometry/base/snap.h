/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block whose outline is moved onto its profile where it lies within a distance w of it.
 *
 * The profile stays. A vertex of the block within w of the profile moves to the nearest point of
 * it, which is rational; or to a point of the profile within w, where each is the other's nearest
 * and both are corners of one sense, so that one fits into the other. A point of the profile within
 * w of an edge of the block, and in none of its vertices then, becomes a vertex of that edge; a
 * crest that no facet ends in would bear nothing so, as a corner on a corner: a piece of the edge
 * is moved onto it, and keeps its direction. So the outline holds points of the profile exactly.
 *
 * An edge moves by w at most, all along it, as its ends do. So it never passes a point of the
 * profile that is farther than w from it, and what lay outside the block by more stays outside. */

#ifndef TP_BASE_SNAP_H
#define TP_BASE_SNAP_H

#include "base/closeness.h"

/* What was moved; squares in scene lengths. */
typedef struct tp_snap {
  tp_polyline outline; /* the new one */
  tp_polyline moved;   /* the vertices of the old one, where they are now */
  long moved_count;    /* of these elsewhere than before */
  long taken_count;    /* points of the profile that became vertices, off the edge before */
  fmpq_t most;         /* square of the farthest move */
  fmpq_t overlap;      /* of the deepest point of one body in the other */
  bool touches;        /* something lies within w: from `left` to `right` along x */
  fmpq_t left, right;
} tp_snap;

void tp_snap_init(tp_snap *snap);
void tp_snap_clear(tp_snap *snap);

/* False when memory is exhausted. Whether the new outline meets itself, or the profile, is for the
 * caller to see. */
TP_MUST_USE bool tp_snap_find(tp_snap *snap, const tp_closeness *near, const fmpq_t within);

/* The shortest edge of the outline, or of the profile from `low` to `high` along x, if it is
 * shorter than `within`: true, with the square of its length, and by its first point. */
bool tp_snap_short_edge(fmpq_t square, bool *of_base, long *edge, const tp_closeness *near,
                        const fmpq_t within);

/* The largest height along y of the new outline over the profile, and the other way round, between
 * the first contact and the last; in doubles, scene lengths, with a bound. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_snap_gap(double *gap, double *error, const tp_snap *snap,
                             const tp_closeness *near);

#endif
