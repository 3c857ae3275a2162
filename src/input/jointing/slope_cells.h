/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cells that a section is cut into: which are blocks and which are ground. Below the base all
 * is ground; so is a cell that reaches an end of the section, as it goes on there, and one that
 * rock encloses on all sides. */

#ifndef TP_JOINTING_SLOPE_CELLS_H
#define TP_JOINTING_SLOPE_CELLS_H

#include "jointing/cuts.h"
#include "jointing/planar_map.h"

typedef enum tp_cell_kind { TP_CELL_BLOCK, TP_CELL_GROUND, TP_CELL_AIR } tp_cell_kind;

/* A tidy map whose cycles are the outlines of blocks, of ground and of the air. */
typedef struct tp_slope_cells {
  const tp_cuts *cuts;
  tp_planar_map map;
  tp_cell_kind *kind; /* of the face on the left of a half-edge */
  long cut_off;       /* how many cells reach an end of the section */
} tp_slope_cells;

/* On failure `cells` is cleared. Bad input: there is no block. */
TP_MUST_USE tp_status tp_slope_cells_init(tp_slope_cells *cells, const tp_cuts *cuts,
                                          tp_message *message);
void tp_slope_cells_clear(tp_slope_cells *cells);

/* The set that made an edge, TP_EDGE_OF_BASE, or TP_EDGE_OF_NONE: along the base its own strength
 * counts where it has one, then that of the first set that has a joint there. */
int tp_slope_cells_edge_set(const tp_slope_cells *cells, size_t edge);
/* Are both pieces of one segment? */
bool tp_slope_cells_same_segment(const tp_slope_cells *cells, size_t edge, size_t other);

#endif
