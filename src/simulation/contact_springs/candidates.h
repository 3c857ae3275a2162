/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of features that may come to touch, by boxes: found anew where the block has moved by as
 * much as they were taken apart. Finding them costs some m log n for m features of the block and n
 * of the base, and all that are near each other; between that a step looks at those alone. */

#ifndef TP_CONTACT_SPRINGS_CANDIDATES_H
#define TP_CONTACT_SPRINGS_CANDIDATES_H

#include "contact_springs/meeting.h"

typedef struct tp_pair {
  long of_block, of_base; /* features */
} tp_pair;

typedef struct tp_box_of_feature {
  double left, right, low, high;
  double right_so_far; /* the largest of all boxes up to this one */
  long feature;
} tp_box_of_feature;

typedef struct tp_near_pairs {
  long count, room;
  tp_pair *pairs; /* by feature of the block, then of the base */
  long box_count;
  tp_box_of_feature *boxes; /* of the base, by their left sides */
  double margin, extent;
  tp_body_state found_at;
} tp_near_pairs;

/* None is found yet. False when memory is exhausted. */
TP_MUST_USE bool tp_near_pairs_init(tp_near_pairs *candidates, const tp_features *of_base,
                                    double extent);
void tp_near_pairs_clear(tp_near_pairs *candidates);

/* May pairs that are not among them touch by now? */
bool tp_near_pairs_are_old(const tp_near_pairs *candidates, const tp_body_state *state);
TP_MUST_USE bool tp_near_pairs_find(tp_near_pairs *candidates, const tp_features *of_block,
                                    const tp_features *of_base, const tp_body_state *state);

#endif
