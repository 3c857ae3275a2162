/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Searches run towards greater numbers, from where nothing moves to where it does: downwards the
 * number is -P. Cost: exclusions within a tenth of the work that the blocks as they lie may take.
 */

#include "block_system/support_onset.h"

#include "block_system/from_limit.h"
#include "block_system/governing_case.h"
#include "block_system/standing.h"
#include "contact_modes/arranged.h"

#include <math.h>

enum { DOWNWARDS, UPWARDS, SEARCHES };
static const long most_work = 20000000;
static const double width_share = 1e-6;

typedef struct onset {
  const tp_support_task *task;
  tp_resting resting;
  tp_arranged arranged;
  tp_known_proofs known[SEARCHES];
  tp_standing_search standing[SEARCHES];
  tp_moving_search moving; /* by -P */
  double start;            /* at which P no motion can begin; below 0: at none that was tried */
} onset;

static tp_status state_at(bool *exists, tp_blocks_at *at, const onset *x, double force,
                          tp_message *message) {
  tp_blocks_at_divisor(at, &x->resting, x->task->system, x->task->divisor);
  *exists = true;
  return tp_resting_loads(at->loads, at->central, &at->weights_alone, &x->resting, &x->task->loads,
                          (tp_near){force, 0}, at->tension, message);
}

static tp_status state_downwards(bool *exists, tp_blocks_at *at, const void *context, double number,
                                 tp_message *message) {
  return state_at(exists, at, context, -number, message);
}

static tp_status state_upwards(bool *exists, tp_blocks_at *at, const void *context, double number,
                               tp_message *message) {
  return state_at(exists, at, context, number, message);
}

/* ---- a first force -----------------------------------------------------------------------------
 */

/* Nothing moves at it: or is a motion found? */
static tp_status try_force(onset *x, double force, tp_message *message) {
  tp_standing_search *s = x->standing + DOWNWARDS;
  bool proven = false;
  tp_status status = tp_moving_try(&x->moving, -force, true, message);
  if (status != TP_OK || (x->moving.found && x->moving.x <= -force)) return status;
  status = tp_standing_prove(&proven, s, -force, -force, message);
  if (status != TP_OK) return status;
  if (proven) x->start = force;
  return proven || s->left[0] == 0 ? TP_OK
                                   : tp_moving_prove_modes(&x->moving, -force, s->left, message);
}

/* That of a method and a little more; then from the least that forces hold with on, by doubling
 * what is added. */
static tp_status find_start(onset *x, tp_message *message) {
  enum { MOST = 14 };
  static const double little = 1.0 / 32, tiny = 1e-3;
  const tp_support_task *t = x->task;
  tp_status status = TP_OK;
  x->start = -1;
  if (t->fails <= 0) status = try_force(x, 0, message);
  if (status == TP_OK && x->start < 0 && t->by_method > t->held) {
    status = try_force(x, t->by_method * (1 + tiny), message);
  }
  const double size = t->held > 0 ? t->held : t->most;
  double more = size * (t->held > 0 ? little : tiny);
  for (int k = 0; k < MOST && status == TP_OK && x->start < 0; k++, more *= 2) {
    if (t->held + more >= t->most) break;
    status = try_force(x, t->held + more, message);
  }
  return status;
}

/* ---- both ends ---------------------------------------------------------------------------------
 */

static tp_moving_range range_below(const onset *x) {
  const double width = width_share * x->start;
  return (tp_moving_range){.from = -x->start,
                           .least = -x->start,
                           .limit = -x->task->fails,
                           .width = width,
                           .step = 1024 * width};
}

/* A motion below it, and down to where none can begin. */
static tp_status find_below(onset *x, double *least, tp_message *message) {
  const tp_moving_range r = range_below(x);
  double standing = r.from;
  *least = x->start;
  if (x->start <= 0) return TP_OK;
  tp_status status = x->moving.found ? tp_moving_follow(&x->moving, r.from, r.width, message)
                                     : tp_moving_from_limit(&x->moving, &r, r.from, message);
  if (status != TP_OK) return status;
  status = tp_standing_to_limit(&standing, &x->moving, x->standing + DOWNWARDS, &r, message);
  *least = -standing;
  return status;
}

static tp_status find_above(onset *x, double *most, tp_message *message) {
  const double limit = x->task->most;
  *most = x->start;
  if (!(limit > x->start)) return TP_OK;
  return tp_standing_extend(most, x->standing + UPWARDS, x->start, limit, width_share * limit,
                            message);
}

static double up(double number) {
  return number > 0 ? nextafter(number, INFINITY) : 0;
}

static void take(tp_system_support *support, const onset *x, double least, double most) {
  const double newtons = x->task->newtons;
  const double moves = x->moving.found ? -x->moving.x : -1;
  support->has_standing = x->start >= 0;
  if (support->has_standing) {
    support->standing_n_m = up(least * newtons);
    support->standing_to_n_m = fmax(support->standing_n_m, nextafter(most * newtons, 0));
  }
  support->has_moving = x->task->fails > 0 || moves >= 0;
  if (support->has_moving) {
    support->moving_n_m = fmax(0, nextafter(fmax(x->task->fails, moves) * newtons, 0));
  }
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status start_search(onset *x, int which, tp_moving_state *state, tp_message *message) {
  tp_status status = tp_known_proofs_init(x->known + which, &x->arranged.resting, message);
  if (status != TP_OK) return status;
  status = tp_standing_init(x->standing + which, &x->arranged, x->known + which, state, x, message);
  x->standing[which].loads_vary = true;
  x->standing[which].most_work = most_work;
  return status;
}

static tp_status search(tp_system_support *support, onset *x, tp_message *message) {
  tp_status status = tp_moving_init(&x->moving, &x->resting, state_downwards, x, message);
  if (status != TP_OK) return status;
  double least = 0, most = 0;
  status = tp_arranged_init(&x->arranged, &x->resting, x->task->resultant->left, message);
  if (status == TP_OK) status = start_search(x, DOWNWARDS, state_downwards, message);
  if (status == TP_OK) status = start_search(x, UPWARDS, state_upwards, message);
  if (status == TP_OK) status = find_start(x, message);
  if (status == TP_OK && x->start >= 0) status = find_below(x, &least, message);
  if (status == TP_OK && x->start >= 0) status = find_above(x, &most, message);
  if (status == TP_OK) take(support, x, least, most);
  for (int k = 0; k < SEARCHES; k++) {
    tp_standing_clear(x->standing + k);
    tp_known_proofs_clear(x->known + k);
  }
  tp_arranged_clear(&x->arranged);
  tp_moving_clear(&x->moving);
  return status;
}

tp_status tp_support_onset_find(tp_system_support *support, const tp_support_task *task,
                                tp_message *message) {
  onset x = {.task = task};
  const tp_built_system *s = task->system;
  support->was_sought = s->assemblage.free_count <= TP_MOST_MOVING_BLOCKS;
  if (!support->was_sought || !(task->most >= task->held)) return TP_OK;
  tp_status status = tp_resting_init(&x.resting, &s->assemblage, s->strengths, message);
  if (status != TP_OK) return status;
  status = search(support, &x, message);
  tp_resting_clear(&x.resting);
  return status;
}
