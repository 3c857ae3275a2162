/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The limit of one question with the friction of the scene, which may depend on the load. */

#ifndef TP_STATIC_LIMIT_LIMIT_FRICTION_H
#define TP_STATIC_LIMIT_LIMIT_FRICTION_H

#include "evaluation/certainty.h"
#include "limit/limit.h"

/* One question about a case, and the answer that is being found. */
typedef struct tp_limit_asking {
  const tp_evaluation *e;
  tp_certainty *certainty;
  tp_cones *cones;
  const tp_limit_question *question;
  tp_limit_answer *answer;
  tp_limit_outcome outcome;
  bool back; /* tilted the other way */
} tp_limit_asking;

/* Finds the answer, and tells the friction that it holds with. How it went is the outcome. */
void tp_limit_meet_friction(tp_limit *result, tp_limit_asking *asking);

#endif
