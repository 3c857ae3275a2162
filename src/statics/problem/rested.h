/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene whose block is set down on its profile and comes to rest (rest/settle.h), upright along
 * its y, as on a level table.
 *
 * Its holes, parts and the points of its loads go with the block; directions of anchors, and the
 * profile, stay. The pose is rational and its contacts exact; where a true one is not, lengths of
 * the block are out by a share of less than 2^-TP_POSE_BITS times some power of two that the
 * block's size over the arm of a turn gives, which is what the digits of such a scene are limited
 * for. */

#ifndef TP_PROBLEM_RESTED_H
#define TP_PROBLEM_RESTED_H

#include "rest/settle.h"
#include "scene/moved.h"
#include "topple.h"

/* Digits that a number of such a scene can be asked for. */
enum { TP_RESTED_DIGITS = 60 };

typedef struct tp_rested {
  tp_scene scene; /* shares with the scene what does not move */
  tp_settling settling;
  fmpq_t left, right; /* from the outermost contacts to the weight's line, scene lengths */
} tp_rested;

/* On failure `*rested` stays NULL: a block that does not come to rest is bad input. */
TP_MUST_USE tp_status tp_rested_init(tp_rested **rested, const tp_scene *scene,
                                     tp_message *message);
void tp_rested_free(tp_rested *rested);

/* Set it down again, shifted along x by so much from where the scene has it. Where it comes to rest
 * (settling.how) the scene, the centroid and the margins are of that pose. */
TP_MUST_USE tp_status tp_rested_shift(tp_rested *rested, const tp_scene *scene,
                                      const fmpq_t shift_x, tp_message *message);

#endif
