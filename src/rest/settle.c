/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "rest/settle.h"

#include "message.h"
#include "rest/drop.h"
#include "rest/turning.h"

#include <string.h>

/* A block that rolls from vertex to vertex meets every one of them a few times. */
long tp_settle_most(long vertices) {
  enum { MEETINGS_OF_EACH = 8 };
  return MEETINGS_OF_EACH * vertices;
}

void tp_settling_clear(tp_settling *settling) {
  tp_bodies_clear(&settling->bodies);
  tp_touches_clear(&settling->touches);
  tp_exact_point_clear(&settling->pivot);
  fmpq_clear(settling->height);
  memset(settling, 0, sizeof *settling);
}

static bool is_stopped(const tp_settling *s, const tp_exact_point *pivot, int turn) {
  bool stopped = false;
  for (long k = 0; k < s->touches.count && !stopped; k++) {
    stopped = tp_touch_stops(&s->bodies, s->touches.items + k, pivot, turn);
  }
  return stopped;
}

/* Where the next turn is about, the one whose arm is longest of those that nothing stops; 0: none.
 * A centroid upright over a point lets itself down either way, if nothing stops it. */
static int next_turn(tp_settling *s) {
  tp_exact_point point;
  fmpq_t arm, longest;
  fmpq_init(arm);
  fmpq_init(longest);
  int turn = 0;
  for (long k = 0; k < s->touches.count; k++) {
    const tp_touch *touch = s->touches.items + k;
    point.x = *tp_touch_x(&s->bodies, touch);
    point.y = *tp_touch_y(&s->bodies, touch);
    fmpq_sub(arm, &s->bodies.centroid.x, &point.x);
    const int own = -fmpq_sgn(arm);
    fmpq_abs(arm, arm);
    if (own == 0) {
      if (!is_stopped(s, &point, 1) || !is_stopped(s, &point, -1)) {
        s->how = TP_SETTLED_BALANCES;
        fmpq_set(&s->pivot.x, &point.x);
        fmpq_set(&s->pivot.y, &point.y);
        turn = 0;
        break;
      }
    } else if (fmpq_cmp(arm, longest) > 0 && !is_stopped(s, &point, own)) {
      fmpq_swap(longest, arm);
      fmpq_set(&s->pivot.x, &point.x);
      fmpq_set(&s->pivot.y, &point.y);
      turn = own;
    }
  }
  fmpq_clear(arm);
  fmpq_clear(longest);
  return turn;
}

/* On an upright end of the rock, below the profile, nothing holds a block: what turns there falls.
 */
static bool is_on_profile(const tp_settling *s) {
  const tp_body *base = &s->bodies.base;
  bool on = true;
  for (int k = 0; k < 2; k++) {
    const long end = k == 0 ? 0 : s->bodies.profile_count - 1;
    on = on &&
         (!fmpq_equal(&s->pivot.x, base->x + end) || fmpq_cmp(&s->pivot.y, base->y + end) >= 0);
  }
  return on;
}

static tp_status turn_once(tp_settling *s, int turn, tp_message *message) {
  tp_turning turning;
  if (!is_on_profile(s)) {
    s->how = TP_SETTLED_ROLLS_OFF;
    return TP_OK;
  }
  tp_turning_init(&turning);
  turning.turn = turn;
  fmpq_set(&turning.pivot.x, &s->pivot.x);
  fmpq_set(&turning.pivot.y, &s->pivot.y);
  tp_status status = tp_turning_find(&turning, &s->bodies, message);
  if (status == TP_OK && turning.pairs.count == 0) {
    s->how = TP_SETTLED_ROLLS_OFF;
  } else if (status == TP_OK && !tp_turning_do(&turning, &s->bodies)) {
    s->how = TP_SETTLED_UNDECIDED;
  } else if (status == TP_OK) {
    status = tp_turning_touches(&s->touches, &turning, &s->bodies, message);
  }
  tp_turning_clear(&turning);
  return status;
}

static tp_status turn_to_rest(tp_settling *s, tp_message *message) {
  const long most = tp_settle_most(s->bodies.block.count + s->bodies.base.count);
  tp_status status = TP_OK;
  while (status == TP_OK && s->how == TP_SETTLED_RESTS) {
    const int turn = next_turn(s);
    if (turn == 0) break;
    if (s->turns++ == most) {
      s->how = TP_SETTLED_GOES_ON;
    } else {
      status = turn_once(s, turn, message);
    }
  }
  return status;
}

tp_status tp_settle(tp_settling *settling, const tp_polyline *outline, const tp_polyline *base_ring,
                    const tp_exact_point *centroid, tp_message *message) {
  memset(settling, 0, sizeof *settling);
  tp_status status = tp_bodies_init(&settling->bodies, outline, base_ring, centroid, message);
  if (status != TP_OK) return status;
  tp_exact_point_init(&settling->pivot);
  fmpq_init(settling->height);
  bool beside = false;
  status = tp_drop(settling->height, &beside, &settling->bodies, &settling->touches, message);
  if (status == TP_OK && beside) settling->how = TP_SETTLED_BESIDE;
  if (status == TP_OK) status = turn_to_rest(settling, message);
  if (status != TP_OK) tp_settling_clear(settling);
  return status;
}
