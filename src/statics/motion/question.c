/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory of a question about the onset of motion. */

#include "motion/question.h"

#include <string.h>

void tp_motion_question_init(tp_motion_question *q, const tp_cones *cones) {
  memset(q, 0, sizeof *q);
  q->cones = cones;
  q->capacity_basis = TP_ONE;
  arb_init(q->scale);
  arb_init(q->x);
  arb_init(q->y);
  arb_init(q->gyration);
  tp_wrench_init(&q->load);
}

void tp_motion_question_clear(tp_motion_question *q) {
  arb_clear(q->scale);
  arb_clear(q->x);
  arb_clear(q->y);
  arb_clear(q->gyration);
  tp_wrench_clear(&q->load);
}
