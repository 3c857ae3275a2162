/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A little beyond the limit, and farther, until a motion is proven. */

#include "block_system/from_limit.h"

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
