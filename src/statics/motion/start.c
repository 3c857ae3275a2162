/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory of the start of a motion. */

#include "motion/start.h"

#include <string.h>

void tp_start_init(tp_start *start, const tp_motion_mode *mode) {
  memset(start, 0, sizeof *start);
  tp_vector_init(&start->twist);
  tp_vector_init(&start->acceleration);
  tp_vector_init(&start->sum);
  start->force_count = mode->edge_count + TP_STRENGTH_PULLS;
  start->forces = _arb_vec_init(start->force_count);
}

void tp_start_clear(tp_start *start) {
  tp_vector_clear(&start->twist);
  tp_vector_clear(&start->acceleration);
  tp_vector_clear(&start->sum);
  _arb_vec_clear(start->forces, start->force_count);
}
