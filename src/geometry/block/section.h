/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cross-section of a block: its rings of exact points, counter-clockwise, and their weights.
 *
 * Ring 0 is the outline, then come the holes, then the parts. A ring's weight is the integer by
 * which its moments enter the sum: w for the outline, -w for a hole, w_k - w for a part, in units
 * of `weight_unit` kN/m3, so that moments of parts of different density stay sums of integers. */

#ifndef TP_BLOCK_SECTION_H
#define TP_BLOCK_SECTION_H

#include "block/arcs.h"
#include "plane/lattice.h"
#include "plane/polyline.h"
#include "scene/scene.h"

#include <flint/fmpq.h>

typedef struct tp_section {
  long hole_count, part_count, ring_count;
  tp_polyline *rings;
  fmpz *ring_weights;          /* ring_count */
  fmpz *density_weights;       /* 1 + part_count: of the block and of each part */
  fmpq_t weight_unit;          /* kN/m3; 1 where the scene gives no unit weight */
  tp_arc_tips arc_tips;        /* of the outline's arcs: the ring holds their tangents */
  const tp_ellipse *ellipse;   /* the outline stands around this; NULL: it is the block's own */
  int threads;                 /* that sum a ring's moments (block/ring_sums.h) */
  bool repairable;             /* `repair: true` is to be offered where it helps */
  tp_notes notes;              /* what a repair moved */
  tp_polyline element_corners; /* of the paper's own elements (teeth, slab); else empty */
} tp_section;

/* Rings of the scene's block, each with at least three vertices. On failure `section` is cleared.
 */
TP_MUST_USE tp_status tp_section_init(tp_section *section, const tp_block_description *block,
                                      tp_message *message);
void tp_section_clear(tp_section *section);

/* Name of a ring in messages: "the outline", "hole 2", "part 1". */
void tp_section_ring_name(char *text, size_t size, const tp_section *section, long ring);

/* Does the edge from a vertex of the outline to the next one stand for a piece of a curve? */
bool tp_section_is_arc(const tp_section *section, long vertex);

#endif
