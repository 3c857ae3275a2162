/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A little beyond the limit, and farther, until a motion is proven. Towards the limit exclusions
 * are extended until one leaves the modes of a motion. */

#include "block_system/from_limit.h"

#include <math.h>

static tp_status move_beyond(tp_moving_search *m, double limit, double step, tp_message *message) {
  enum { STEPS = 4 };
  static const double growth = 8;
  tp_status status = TP_OK;
  for (int k = 0; k < STEPS && !m->found && status == TP_OK; k++, step *= growth) {
    status = tp_moving_try(m, limit + step, true, message);
  }
  return status;
}

tp_status tp_moving_from_limit(tp_moving_search *m, const tp_moving_range *r, double least,
                               tp_message *message) {
  const tp_status status = move_beyond(m, r->limit, r->step, message);
  return status == TP_OK && m->found ? tp_moving_follow(m, least, r->width, message) : status;
}

tp_status tp_moving_least(tp_moving_search *m, const tp_moving_range *r, tp_message *message) {
  tp_moving_search other;
  tp_status status = tp_moving_follow(m, r->least, r->width, message);
  if (status != TP_OK || m->x <= r->least) return status;
  status = tp_moving_init(&other, m->resting, m->state, m->context, message);
  if (status != TP_OK) return status;
  status = tp_moving_from_limit(&other, r, r->least, message);
  if (status == TP_OK && other.x < m->x) {
    const tp_moving_search own = *m;
    *m = other;
    other = own;
  }
  tp_moving_clear(&other);
  return status;
}

/* What an exclusion just past where it is proven leaves is tried as a motion, and followed down. */
static tp_status close_gap(tp_moving_search *m, tp_standing_search *s, double *standing,
                           double limit, double width, tp_message *message) {
  enum { MOST = 4 };
  tp_status status = TP_OK;
  for (int k = 0; k < MOST && status == TP_OK; k++) {
    const double end = fmin(m->x, limit), at = *standing + 4 * width;
    bool proven = false;
    if (end - *standing <= 8 * width || s->work > s->most_work) break;
    status = tp_standing_prove(&proven, s, at, at, message);
    if (status != TP_OK || proven || s->left[0] == 0) break;
    const double before = m->x;
    status = tp_moving_prove_modes(m, at, s->left, message);
    if (status != TP_OK || !m->found || m->x >= before) break;
    status = tp_moving_follow(m, *standing, width, message);
  }
  return status;
}

tp_status tp_standing_to_limit(double *standing, tp_moving_search *m, tp_standing_search *s,
                               const tp_moving_range *r, tp_message *message) {
  const double end = fmin(m->x, r->limit);
  const tp_status status = tp_standing_extend(standing, s, r->from, end, r->width, message);
  return status == TP_OK ? close_gap(m, s, standing, r->limit, r->width, message) : status;
}
