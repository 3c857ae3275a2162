/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An interval is tried as a whole, and halved towards its lower end until it is proven; then as
 * much again is tried beyond. */

#include "block_system/standing.h"

#include <stdlib.h>
#include <string.h>

void tp_standing_clear(tp_standing_search *s) {
  for (int k = 0; k < 2; k++) tp_blocks_at_clear(s->ends + k);
  free(s->left);
  memset(s, 0, sizeof *s);
}

tp_status tp_standing_init(tp_standing_search *s, const tp_resting *r, tp_moving_state *state,
                           const void *context, tp_message *message) {
  *s = (tp_standing_search){.resting = r, .state = state, .context = context};
  s->left = calloc((size_t)r->contact_count + 1, sizeof *s->left);
  bool done = s->left != NULL;
  for (int k = 0; k < 2; k++) done = tp_blocks_at_init(s->ends + k, r) && done;
  if (done) return TP_OK;
  tp_standing_clear(s);
  return tp_fail_memory(message, "the motions");
}

/* An interval that takes far more than the last one that was proven is too wide. */
static long most_work(const tp_standing_search *s) {
  enum { TIMES = 6 };
  const long enough = s->work + TIMES * s->proof_work;
  return s->proof_work > 0 && enough < s->most_work ? enough : s->most_work;
}

/* Strength is greatest where x, of a divisor, is least. */
tp_status tp_standing_prove(bool *proven, tp_standing_search *s, double from, double to,
                            tp_message *message) {
  *proven = false;
  memset(s->left, 0, (size_t)s->resting->contact_count * sizeof *s->left);
  bool exists = true;
  tp_status status = TP_OK;
  for (int k = 0; k < 2 && exists && status == TP_OK; k++) {
    status = s->state(&exists, s->ends + k, s->context, k == 0 ? from : to, message);
  }
  if (status != TP_OK || !exists) return status;
  const tp_modes_question q = {.resting = s->resting,
                               .friction = {s->ends[1].friction, s->ends[0].friction},
                               .cohesion = {s->ends[1].cohesion, s->ends[0].cohesion},
                               .loads = {s->ends[0].loads, s->ends[1].loads},
                               .load_count = s->loads_vary && to > from ? 2 : 1};
  const long before = s->work;
  tp_exclusion e = {.most_work = most_work(s), .work = before, .left = s->left};
  status = tp_exclusion_find(&e, &q, message);
  s->work = e.work;
  *proven = status == TP_OK && e.is_proven;
  if (*proven) s->proof_work = s->work - before;
  return status;
}

tp_status tp_standing_extend(double *x, tp_standing_search *s, double from, double limit,
                             double width, tp_message *message) {
  tp_status status = TP_OK;
  *x = from;
  double to = limit;
  while (status == TP_OK && to - *x > width && s->work <= s->most_work) {
    bool proven = false;
    status = tp_standing_prove(&proven, s, *x, to, message);
    if (proven) {
      const double step = to - *x;
      *x = to;
      to = to + step < limit ? to + step : limit;
    } else {
      to = *x + (to - *x) / 2;
    }
  }
  return status;
}
