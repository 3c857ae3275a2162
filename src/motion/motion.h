/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* At which tilts can a block begin to move from rest (mechanics section 6a)? */

#ifndef TP_MOTION_H
#define TP_MOTION_H

#include "motion/strata.h"
#include "motion/tilts.h"

/* Forces are over the weight, accelerations over gravity. Lengths are `scale` times those of the
 * cones, moments about the centroid, which lies at (x, y) of these longer units from their origin;
 * so all of it is whole where the block is. */
typedef struct tp_motion_question {
  const tp_cones *cones; /* without capacities */
  arb_t scale, x, y;
  arb_t gyration; /* square of its radius about the centroid */
  tp_wrench load; /* of all loads, about the centroid, as functions of the tilt; any factor */
  bool through_centroid; /* the loads have no moment about it */
  const tp_cones
      *strong; /* the same cones with their capacities, for cohesion and bonds; or NULL */
  tp_judge judge;
  tp_work *work;
} tp_motion_question;

void tp_motion_question_init(tp_motion_question *question, const tp_cones *cones);
void tp_motion_question_clear(tp_motion_question *question);

/* Every mode with the tilts at which it can begin. */
typedef struct tp_motion_mode {
  tp_mechanism mechanism;
  int ray_count;
  long rays[2];
  long edge_count;
  tp_mode_edge *edges;
} tp_motion_mode;

typedef struct tp_motions {
  tp_normals normals;
  tp_twists twists;
  long mode_count, mode_room;
  tp_motion_mode *modes; /* those that can begin at some tilt */
  tp_tilts spans;        /* each with its mode, in their order; not merged */
} tp_motions;

TP_MUST_USE tp_motion_outcome tp_motions_init(tp_motions *motions,
                                              const tp_motion_question *question);
void tp_motions_clear(tp_motions *motions);

#endif
