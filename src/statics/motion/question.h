/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is asked: a contact, the loads on the block, its inertia. */

#ifndef TP_MOTION_QUESTION_H
#define TP_MOTION_QUESTION_H

#include "linear_program/cones.h"
#include "load/wrench.h"
#include "number/judge.h"
#include "number/work.h"

/* Forces are over the weight, accelerations over gravity. Lengths are `scale` times those of the
 * cones, moments about the centroid, which lies at (x, y) of these longer units from their origin;
 * so all of it is whole where the block is. */
typedef struct tp_motion_question {
  const tp_cones *cones; /* without capacities */
  arb_t scale, x, y;
  arb_t gyration; /* square of its radius about the centroid */
  tp_wrench load; /* of all loads, about the centroid, as functions of the tilt; any factor */
  bool through_centroid; /* the loads have no moment about it */
  /* Is the moment about a site of all loads with one function of the tilt zero, exactly? Asked
   * where its ball contains zero; NULL: nobody knows. */
  bool (*vanishes)(const void *loads, long site, int basis);
  const void *loads;
  const tp_cones
      *strong;        /* the same cones with their capacities, for cohesion and bonds; or NULL */
  int capacity_basis; /* with which function of the tilt capacities go: TP_ONE, unless changed */
  bool keeps_all;     /* all modes, not those alone that can begin at some tilt */
  tp_judge judge;
  tp_work *work;
} tp_motion_question;

void tp_motion_question_init(tp_motion_question *question, const tp_cones *cones);
void tp_motion_question_clear(tp_motion_question *question);

#endif
