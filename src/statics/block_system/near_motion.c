/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks are let go at a few divisors of strength, from the least on; the first motion that is
 * proven is followed down by halving. */

#include "block_system/near_motion.h"

#include "block_system/column_row.h"
#include "block_system/moving.h"
#include "block_system/system_start.h"

#include <math.h>

typedef struct letting {
  const tp_built_system *system;
  const tp_resultant *resultant;
  const tp_resting *resting;
} letting;

static tp_status state_at(bool *exists, tp_blocks_at *at, const void *context, double logarithm,
                          tp_message *message) {
  const letting *l = context;
  tp_blocks_at_divisor(at, l->resting, l->system, exp(logarithm));
  *exists = true;
  return tp_blocks_at_rest(at, l->resting, l->resultant, message);
}

/* As they are given, and by a twentieth more than the estimate. */
static int set_divisors(double *at, const tp_system_case *one) {
  static const double more[] = {1.05};
  int count = 0;
  at[count++] = 0;
  if (one->has_undilated_fos) {
    for (size_t k = 0; k < sizeof more / sizeof *more; k++) {
      const double next = log(more[k] * one->undilated_fos);
      if (next > 0) at[count++] = next;
    }
  }
  return count;
}

/* The least number from `low` on, where it is not proven, at which the motion still is. */
static tp_status halve(tp_moving_search *m, double low, tp_message *message) {
  static const double width = 1e-3;
  tp_status status = TP_OK;
  while (status == TP_OK && m->x - low > width) {
    const double middle = low + (m->x - low) / 2;
    status = tp_moving_prove(m, middle, m->proven, message);
    if (m->x > middle) low = middle;
  }
  return status;
}

static tp_status search(tp_system_case *one, tp_moving_search *m, tp_message *message) {
  enum { MOST = 2 };
  double at[MOST];
  const int count = set_divisors(at, one);
  tp_status status = TP_OK;
  for (int k = 0; k < count && status == TP_OK && !m->found; k++) {
    status = tp_moving_try_few(m, at[k], message);
    if (status == TP_OK && m->found && k > 0) status = halve(m, 0, message);
  }
  if (status != TP_OK || !m->found) return status;
  one->has_moving_fos = true;
  one->moving_fos = m->x > 0 ? nextafter(exp(m->x), INFINITY) : 1;
  if (m->x <= 0 && one->verdict == TP_SYSTEM_CAN_HOLD) one->verdict = TP_SYSTEM_MAY_MOVE;
  return tp_system_start_set(one, m, message);
}

tp_status tp_near_motion_find(tp_system_case *one, const tp_built_system *s,
                              const tp_resultant *resultant, tp_message *message) {
  if (s->assemblage.free_count > TP_MOST_NEAR_MOTION_COLUMNS || resultant->beyond) return TP_OK;
  tp_column_row row;
  tp_resting resting;
  tp_moving_search moving;
  tp_status status = tp_column_row_find(&row, s, resultant->left, message);
  if (status != TP_OK) return status;
  const bool is_row = row.count > 0;
  tp_column_row_clear(&row);
  if (!is_row && s->assemblage.free_count > TP_MOST_NEAR_MOTION_BLOCKS) return TP_OK;
  status = tp_resting_init(&resting, &s->assemblage, s->strengths, message);
  if (status != TP_OK) return status;
  const letting l = {s, resultant, &resting};
  status = tp_moving_init(&moving, &resting, state_at, &l, message);
  if (status == TP_OK) {
    status = search(one, &moving, message);
    tp_moving_clear(&moving);
  }
  tp_resting_clear(&resting);
  return status;
}
