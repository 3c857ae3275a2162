/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* At which tilts can a block begin to move from rest (docs/mechanics.md section 6a)? Mode by mode
 * (motion/strata.h) the planes that bound its cone of loads (motion/bounds.h) are inequalities
 * h . w(alpha) >= 0; the tilts that keep all of them are intersected (motion/tilts.h). */

#ifndef TP_MOTION_MOTION_H
#define TP_MOTION_MOTION_H

#include "motion/question.h"
#include "motion/strata.h"
#include "motion/tilts.h"

/* Every mode with the tilts at which it can begin. */
typedef struct tp_motion_mode {
  tp_mechanism mechanism;
  int ray_count;
  long rays[2];
  long edge_count;
  tp_cone_edge *edges;
} tp_motion_mode;

typedef struct tp_motions {
  tp_normals normals;
  tp_twists twists;
  long mode_count, mode_room;
  tp_motion_mode *modes; /* those that can begin at some tilt, or all, where that is asked for */
  tp_motion_tilts spans; /* each with its mode, in their order; not merged */
} tp_motions;

TP_MUST_USE tp_motion_outcome tp_motions_init(tp_motions *motions,
                                              const tp_motion_question *question);
void tp_motions_clear(tp_motions *motions);

#endif
