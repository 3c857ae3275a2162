/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene whose block is shifted along the mated base that it fits: the counterpart of its
 * underside is from then on a profile of its own, and the block lies above that, shifted along x,
 * to be set down until it rests (problem/rested.h). All of it exact.
 *
 * Its holes, parts and the points of its loads go with the block. */

#ifndef TP_PROBLEM_JOINTED_H
#define TP_PROBLEM_JOINTED_H

#include "problem/sole.h"
#include "scene/moved.h"
#include "topple.h"

typedef struct tp_jointed {
  tp_scene scene;             /* shares with the scene what does not move */
  tp_sole sole;               /* what was mated */
  long base_first;            /* the edge of the profile that fitted the first of these */
  fmpq_t shift;               /* scene lengths */
  bool sought;                /* it was searched: */
  fmpq_t before;              /* the last shift before this that was looked at, and came to rest, */
  tp_bounded before_matching; /* and what was closed there */
} tp_jointed;

/* By a shift. On failure `*jointed` stays NULL. */
TP_MUST_USE tp_status tp_jointed_init(tp_jointed **jointed, const tp_scene *scene,
                                      const fmpq_t shift, tp_message *message);

/* By the shift that the scene asks for, or by one that is searched (problem/jointed_search.c). */
TP_MUST_USE tp_status tp_jointed_ask(tp_jointed **jointed, const tp_scene *scene,
                                     tp_message *message);
void tp_jointed_free(tp_jointed *jointed);

#endif
