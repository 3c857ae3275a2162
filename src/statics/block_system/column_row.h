/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Columns side by side on the ground, as Goodman and Bray (1976) treat them: each free block stands
 * on one plane of the ground and touches the next one on either side along one plane; these sides
 * are all parallel. Whether blocks are such a row is told exactly, of their contacts; then it is
 * measured in doubles.
 *
 * Axes here: u is x towards the slope, away from the side that columns are pressed to, so that the
 * toe has the least u; v is y. */

#ifndef TP_BLOCK_SYSTEM_COLUMN_ROW_H
#define TP_BLOCK_SYSTEM_COLUMN_ROW_H

#include "block_system/built_system.h"

typedef struct tp_row_vector {
  double u, v;
} tp_row_vector;

typedef struct tp_row_column {
  long block;
  double weight_n_m;
  /* From the edge that it topples about, the end of its base towards the toe, in metres: */
  tp_row_vector centroid;
  tp_row_vector reference; /* to the point about which loads on the block have their moments */
  tp_row_vector upper; /* to the top of the contact with the next column up; of the last: zero */
  tp_row_vector lower; /* down; of the toe: the top of its free side */
  tp_row_vector along_base; /* unit, up the slope */
  double base_tangent;      /* tan(phi) of the base, the least of its contacts */
  double side_tangent;      /* of the sides to the next column up; of the last: 0 */
} tp_row_column;

typedef struct tp_column_row {
  long count; /* 0: the blocks are no such row, and: */
  char why_not[400];
  tp_row_column *columns;    /* from the toe up */
  tp_row_vector along_sides; /* unit, upwards */
} tp_column_row;

/* Of blocks that are pressed to the left or to the right. TP_OK also where they are no row. On
 * failure cleared. */
TP_MUST_USE tp_status tp_column_row_find(tp_column_row *row, const tp_built_system *system,
                                         bool towards_left, tp_message *message);
void tp_column_row_clear(tp_column_row *row);

#endif
