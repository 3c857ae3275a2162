/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From the chains of a section to one outline with its holes, or to one profile from left to right.
 *
 * What closes within the outline is a hole of it: there the plane cuts a cavity of the solid. That
 * is told by where it lies, not by how faces turn, which in many meshes are not all right.
 *
 * Lengths become those of the scene. A coordinate that ends as a decimal, or as a binary fraction
 * of at most 128 bits, stays exact; a quotient is rounded to a multiple of the largest power of ten
 * that is at most 1e-9 of the section's greater side, so by less than half of that: thousands of
 * quotients without a common denominator cannot be computed with exactly in seconds. */

#ifndef TP_FORMAT_SECTION_TAKE_H
#define TP_FORMAT_SECTION_TAKE_H

#include "common/notes.h"
#include "format/mesh_cut.h"

typedef struct tp_section_wish {
  bool closed;      /* an outline; else a profile, of a closed chain its upper side */
  bool largest;     /* of several the largest area, or the longest; else several are refused */
  fmpq_t gap;       /* ends as near as that are joined, in scene lengths */
  fmpq_t factor;    /* scene lengths per length of the mesh */
  const char *unit; /* of the scene's lengths, for messages */
  tp_place place;   /* that messages give */
} tp_section_wish;

void tp_section_wish_init(tp_section_wish *wish);
void tp_section_wish_clear(tp_section_wish *wish);

/* Into an empty line, and its holes into an empty list; `holes` NULL: it may have none. The section
 * is used up. Notes tell what was taken and how it was rounded. */
TP_MUST_USE tp_status tp_section_take(tp_polyline *line, tp_polylines *holes,
                                      tp_mesh_section *section, const tp_section_wish *wish,
                                      tp_notes *notes, tp_message *message);

/* Steps of it. Scale and round all chains; the resolution is zero where all were exact. */
void tp_section_round(tp_mesh_section *section, const fmpq_t factor, fmpq_t resolution);
/* Join open chains end to end, the nearest ends first, as far as `gap` allows; an outline that
 * stays open is refused. `*joined` counts, `*widest` is the widest gap. */
TP_MUST_USE tp_status tp_section_join(tp_mesh_section *section, const tp_section_wish *wish,
                                      long *joined, double *widest, tp_message *message);

/* Which chains are closed and lie within the one with the number `outer`, which is closed, into
 * `within`, an array as long as the section: the number of the closed chains around each but for
 * that, or -1 of those that do not. Chains that cross are what the first of their points says. */
TP_MUST_USE bool tp_section_nest(long *within, const tp_mesh_section *section, long outer);

#endif
