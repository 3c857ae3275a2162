/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The block as elements: the paper's own slabs and triangles for toothed blocks (Appendix A), the
 * triangles of the triangulation for any other. All moments are exact integers on the lattice. */

#ifndef TP_BLOCK_ELEMENTS_H
#define TP_BLOCK_ELEMENTS_H

#include "block/section.h"
#include "geom/geom.h"
#include "topple.h"

/* weight2 = density weight times twice the area; (x6, y6) = six times the centroid. */
typedef struct tp_exact_element {
  tp_element_kind kind;
  size_t part;
  long corner[3]; /* points of the lattice: of a slab the lower left and the upper right one */
  fmpz weight2, x6, y6;
} tp_exact_element;

/* Elements in the order of one coordinate of their centroids, with running sums of weight2 and of
 * weight2 times that coordinate: moments about any axis then take a binary search. */
typedef struct tp_element_order {
  fmpz *position6; /* count, ascending */
  fmpz *weight2;   /* count + 1: sums of the elements before */
  fmpz *moment12;
} tp_element_order;

typedef struct tp_elements {
  long count;
  tp_exact_element *items;
  tp_element_order along_x, along_y;
} tp_elements;

/* The elements of a section: by its element corners, the chain `corner_chain` of the lattice, where
 * it has some and neither holes nor parts; else by the triangles. */
TP_MUST_USE tp_status tp_elements_init(tp_elements *elements, const tp_section *section,
                                       const tp_lattice *lattice, long corner_chain,
                                       const tp_geom_triangulation *triangulation,
                                       tp_message *message);
void tp_elements_clear(tp_elements *elements);

/* Does the section fall into the elements of Appendix A, without a triangulation? */
bool tp_elements_are_given(const tp_section *section);

/* Moments of the weights on either side of `position` on an axis: sums of weight2 times six times
 * the distance, beyond it and before it. */
void tp_elements_moments(fmpz_t beyond, fmpz_t before, const tp_elements *elements,
                         const tp_element_order *order, const fmpz_t position);

#endif
