/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is wrong with a cell, whatever the rest of its row. */

#ifndef TP_SURVEY_CELL_CHECK_H
#define TP_SURVEY_CELL_CHECK_H

#include "survey/faults.h"
#include "survey/tree.h"

/* Add to the faults what is wrong with the cell; `column` from 0. A cell is data: in a column of
 * numbers it is one plain number, and nowhere is anything calculated in it. */
TP_MUST_USE tp_status tp_cell_check(tp_row_faults *faults, const tp_column *head, size_t column,
                                    const char *cell, const tp_node *root, tp_message *message);

/* The dip and the dip direction of a field of a plane, "30/120", into texts that the caller frees;
 * else the fault is added, and both are NULL. */
TP_MUST_USE tp_status tp_cell_split_plane(char **dip, char **direction, tp_row_faults *faults,
                                          const tp_column *head, size_t column, const char *cell,
                                          tp_message *message);

/* Of a row with faults, of which no scene is read: add that it has no dip, or no friction. */
TP_MUST_USE tp_status tp_row_check_missing(tp_row_faults *faults, const tp_node *root,
                                           tp_message *message);

/* What is said where one of these is not given. */
extern const char tp_row_no_dip[], tp_row_no_friction[];

#endif
