/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tree of a scene file, changed at keys with dots: block.slab.width, loads.anchors.1.force_kn.
 */

#ifndef TP_SURVEY_TREE_H
#define TP_SURVEY_TREE_H

#include "survey/survey.h"

/* The child of a part of a key: by its name, or in a list by its number from 1 on. NULL: there is
 * none. */
tp_node *tp_tree_child(const tp_node *at, const char *part, size_t length);

/* The text as the scalar at the key, made with the maps on the way to it where there is none. */
TP_MUST_USE tp_status tp_tree_put(tp_node *root, const char *key, const char *text, tp_mark mark,
                                  tp_message *message);

/* A copy of the node with its places, below the parent, or NULL for a tree of its own; it is as
 * deep as the reader allows. NULL when memory is exhausted. */
tp_node *tp_tree_copy(tp_node *parent, const tp_node *node);

void tp_tree_drop(tp_node *parent, const char *key);

/* The mark of what comes from a column. */
static inline tp_mark tp_mark_of_column(size_t column) {
  return (tp_mark){-(int)column - 1, 0};
}

/* The cells of a row at their keys, lengths and other numbers in the units of these; what is wrong
 * with them is added to the faults, and is bad input. */
TP_MUST_USE tp_status tp_survey_put_cells(tp_node *root, tp_row_faults *faults,
                                          const tp_survey *survey, size_t row, tp_message *message);
/* The file with the outline of the block in the place of its form; `scene` is the file beside which
 * the scene names others. */
TP_MUST_USE tp_status tp_survey_put_outline(tp_node *root, const tp_survey *survey, size_t row,
                                            const char *scene, tp_message *message);

#endif
