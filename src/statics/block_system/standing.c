/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An interval is tried as a whole, and halved towards its lower end until it is proven; then twice
 * as much is tried beyond. Unless one proof takes very little of all work, a little of the interval
 * is tried first: what is known of that makes the next proofs cheap. A try may take little at
 * first, so that those which cannot succeed leave enough to the others, and twice as much after
 * each that was given up for that. */

#include "block_system/standing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The first tries may take so many times as much as the last proof, or such a part of all work. */
enum { TIMES = 6, PARTS = 256 };

static void clear_state(tp_standing_state *s) {
  free(s->friction);
  free(s->cohesion);
  free(s->bond);
  free(s->loads);
}

static bool init_state(tp_standing_state *s, const tp_resting *r) {
  const size_t count = (size_t)r->contact_count + 1;
  s->friction = calloc(count, sizeof *s->friction);
  s->cohesion = calloc(count, sizeof *s->cohesion);
  s->bond = calloc(2 * count, sizeof *s->bond);
  s->loads = calloc((size_t)r->rows + 1, sizeof *s->loads);
  return s->friction != NULL && s->cohesion != NULL && s->bond != NULL && s->loads != NULL;
}

void tp_standing_clear(tp_standing_search *s) {
  tp_blocks_at_clear(&s->at);
  tp_virtual_known_clear(&s->virtual_known);
  for (int k = 0; k < 2; k++) clear_state(s->ends + k);
  free(s->left_arranged);
  free(s->left);
  memset(s, 0, sizeof *s);
}

tp_status tp_standing_init(tp_standing_search *s, const tp_arranged *arranged,
                           tp_known_proofs *known, tp_moving_state *state, const void *context,
                           tp_message *message) {
  *s = (tp_standing_search){
      .arranged = arranged, .known = known, .state = state, .context = context};
  const tp_resting *r = arranged->given;
  s->left = calloc((size_t)r->contact_count + 1, sizeof *s->left);
  s->left_arranged = calloc((size_t)r->contact_count + 1, sizeof *s->left_arranged);
  bool done = tp_blocks_at_init(&s->at, r) && s->left != NULL && s->left_arranged != NULL;
  for (int k = 0; k < 2; k++) done = init_state(s->ends + k, r) && done;
  if (done) return TP_OK;
  tp_standing_clear(s);
  return tp_fail_memory(message, "the motions");
}

/* No try takes more than half of what is left, but for one or two like the last proof. */
static long most_work(const tp_standing_search *s, bool is_wide) {
  const long rest = s->most_work - s->work, last = s->proof_work;
  if (!is_wide || rest <= 0) return s->most_work;
  long most = s->try_work < rest / 2 ? s->try_work : rest / 2;
  if (most < 2 * last) most = 2 * last < rest ? 2 * last : rest;
  return s->work + most;
}

/* Of an interval: all of it where what is left is enough for many proofs like the last one. */
static double first_step(const tp_standing_search *s, double all) {
  enum { MANY = 256, STEPS = 32 };
  return s->proof_work > (s->most_work - s->work) / MANY ? all / STEPS : all;
}

static tp_status set_end(bool *exists, tp_standing_search *s, int end, double x,
                         tp_message *message) {
  const tp_status status = s->state(exists, &s->at, s->context, x, message);
  if (status != TP_OK || !*exists) return status;
  tp_arranged_friction(s->ends[end].friction, s->arranged, s->at.friction);
  tp_arranged_cohesion(s->ends[end].cohesion, s->arranged, s->at.cohesion);
  s->ends[end].has_bond = s->at.has_bond;
  if (s->at.has_bond) tp_arranged_bonds(s->ends[end].bond, s->arranged, s->at.bond);
  tp_arranged_loads(s->ends[end].loads, s->arranged, s->at.central);
  return TP_OK;
}

/* Once modes were too many for their search. */
static tp_status prove_at_once(bool *proven, tp_standing_search *s, const tp_modes_question *q,
                               tp_message *message) {
  enum { MOST_IN_VAIN = 8 };
  if (s->virtual_in_vain == MOST_IN_VAIN) return TP_OK;
  const tp_status status =
      tp_virtual_motion_find(proven, &s->virtual_known, s->arranged, q, message);
  if (status != TP_OK) return status;
  s->by_virtual_motions = s->by_virtual_motions || *proven;
  if (!*proven) s->virtual_in_vain++;
  return TP_OK;
}

static tp_status prove_by_modes(bool *proven, bool *is_spent, tp_standing_search *s,
                                const tp_modes_question *q, bool is_wide, tp_message *message) {
  const long before = s->work;
  tp_exclusion e = {.most_work = most_work(s, is_wide),
                    .work = before,
                    .left = s->left_arranged,
                    .known = s->known};
  const tp_status status = tp_exclusion_find(&e, q, message);
  s->work = e.work;
  *proven = status == TP_OK && e.is_proven;
  *is_spent = status == TP_OK && !e.is_proven && !e.has_left;
  if (*proven) s->proof_work = s->work - before;
  if (e.has_left) tp_arranged_modes(s->left, s->arranged, s->left_arranged);
  return status;
}

/* Strength is greatest where x, of a divisor, is least. */
tp_status tp_standing_prove(bool *proven, tp_standing_search *s, double from, double to,
                            tp_message *message) {
  const tp_resting *r = &s->arranged->resting;
  *proven = false;
  memset(s->left, 0, (size_t)r->contact_count * sizeof *s->left);
  bool exists = true, weights_alone = true;
  tp_status status = TP_OK;
  for (int k = 0; k < 2 && exists && status == TP_OK; k++) {
    status = set_end(&exists, s, k, k == 0 ? from : to, message);
    weights_alone = weights_alone && s->at.weights_alone;
  }
  if (status != TP_OK || !exists) return status;
  const bool has_bond = s->ends[0].has_bond && s->ends[1].has_bond;
  const tp_modes_question q = {
      .resting = r,
      .friction = {s->ends[1].friction, s->ends[0].friction},
      .cohesion = {s->ends[1].cohesion, s->ends[0].cohesion},
      .loads = {s->ends[0].loads, s->ends[1].loads},
      .bond = {has_bond ? s->ends[0].bond : NULL, has_bond ? s->ends[1].bond : NULL},
      .load_count = s->loads_vary && to > from ? 2 : 1,
      .weights_alone = weights_alone};
  bool is_spent = s->by_virtual_motions;
  if (!is_spent) status = prove_by_modes(proven, &is_spent, s, &q, to > from, message);
  return status == TP_OK && is_spent ? prove_at_once(proven, s, &q, message) : status;
}

/* By virtual motions alone: of much less strength at once, of more load by little. */
static tp_status extend_by_virtual_motions(double *x, tp_standing_search *s, double limit,
                                           double width, tp_message *message) {
  enum { PARTS_OF_STRENGTH = 2, PARTS_OF_LOAD = 64, MOST_OF_STRENGTH = 6, MOST_OF_LOAD = 8 };
  const int most = s->loads_vary ? MOST_OF_LOAD : MOST_OF_STRENGTH;
  double step = (limit - *x) / (s->loads_vary ? PARTS_OF_LOAD : PARTS_OF_STRENGTH);
  tp_status status = TP_OK;
  for (int k = 0; k < most && step > width && *x < limit && status == TP_OK; k++) {
    const double to = fmin(limit, *x + step);
    bool proven = false;
    status = tp_standing_prove(&proven, s, *x, to, message);
    if (proven) *x = to;
    step = proven ? 2 * step : step / 2;
    if (*x + step >= limit) step = (limit - *x) / 2;
  }
  return status;
}

tp_status tp_standing_extend(double *x, tp_standing_search *s, double from, double limit,
                             double width, tp_message *message) {
  const long least = (s->most_work - s->work) / PARTS, like_last = TIMES * s->proof_work;
  tp_status status = TP_OK;
  bool can_move = false; /* at the limit, by what was left of the try to reach it */
  double step = fmax(first_step(s, limit - from), 2 * width), to = fmin(limit, from + step);
  *x = from;
  if (s->by_virtual_motions) return extend_by_virtual_motions(x, s, limit, width, message);
  s->try_work = like_last > least ? like_last : least;
  while (status == TP_OK && to - *x > width && s->work <= s->most_work) {
    bool proven = false;
    status = tp_standing_prove(&proven, s, *x, to, message);
    const bool is_left = s->left[0] != 0;
    step = proven ? 2 * (to - *x) : (to - *x) / 2;
    if (proven) *x = to;
    if (!proven && !is_left) s->try_work *= 2;
    if (TIMES * s->proof_work > s->try_work) s->try_work = TIMES * s->proof_work;
    can_move = can_move || (!proven && to >= limit && is_left);
    to = fmin(limit, *x + step);
    if (can_move && to >= limit) to = *x + (limit - *x) / 2;
    if (s->by_virtual_motions) return extend_by_virtual_motions(x, s, limit, width, message);
  }
  return status;
}
