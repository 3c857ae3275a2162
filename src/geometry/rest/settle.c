/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The drop, then one turn after another about the contact with the longest arm that no other
 * contact stops, until none is left or the block leaves its base (docs/rest.md). */

#include "rest/settle.h"

#include "common/budget.h"
#include "common/message.h"
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

/* From both ends inwards: touches stand from left to right, and of a block on many points the
 * outermost stop most turns. */
static bool is_stopped(tp_settling *s, const tp_touch *about, int turn) {
  bool stopped = false;
  for (long k = 0; k < s->touches.count && !stopped; k++) {
    const long next = k % 2 == 0 ? k / 2 : s->touches.count - 1 - k / 2;
    s->work += TP_REST_EXACT_LOOKS;
    stopped = tp_touch_stops(&s->bodies, s->touches.items + next, about, turn);
  }
  return stopped;
}

/* Where the next turn is about, the one whose arm is longest of those that nothing stops; 0: none.
 * A centroid upright over a point lets itself down either way, if nothing stops it. */
static int next_turn(tp_settling *s, tp_touch *about) {
  fmpq_t arm, longest;
  fmpq_init(arm);
  fmpq_init(longest);
  int turn = 0;
  for (long k = 0; k < s->touches.count; k++) {
    const tp_touch *touch = s->touches.items + k;
    const tp_exact_point point = tp_touch_point(&s->bodies, touch);
    fmpq_sub(arm, &s->bodies.centroid.x, &point.x);
    const int own = -fmpq_sgn(arm);
    fmpq_abs(arm, arm);
    if (own == 0) {
      if (!is_stopped(s, touch, 1) || !is_stopped(s, touch, -1)) {
        s->how = TP_SETTLED_BALANCES;
        fmpq_set(&s->pivot.x, &point.x);
        fmpq_set(&s->pivot.y, &point.y);
        turn = 0;
        break;
      }
    } else if (fmpq_cmp(arm, longest) > 0 && !is_stopped(s, touch, own)) {
      fmpq_swap(longest, arm);
      fmpq_set(&s->pivot.x, &point.x);
      fmpq_set(&s->pivot.y, &point.y);
      *about = *touch;
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

/* Are the pairs that may touch next beyond a budget? */
static bool is_refused(tp_settling *s, const tp_candidates *pairs) {
  if (pairs->too_many) s->how = TP_SETTLED_TOO_DEAR;
  if (pairs->too_blind) s->how = TP_SETTLED_TOO_BLIND;
  return pairs->too_many || pairs->too_blind;
}

static tp_status turn_once(tp_settling *s, int turn, const tp_touch *about, tp_message *message) {
  tp_turning turning;
  if (!is_on_profile(s)) {
    s->how = TP_SETTLED_ROLLS_OFF;
    return TP_OK;
  }
  tp_turning_init(&turning, &s->bodies, about, turn);
  tp_status status = tp_turning_find(&turning, &s->bodies, message);
  if (is_refused(s, &turning.pairs)) {
    status = TP_OK;
  } else if (status == TP_OK && turning.pairs.count == 0) {
    s->how = TP_SETTLED_ROLLS_OFF;
  } else if (status == TP_OK && !tp_turning_do(&turning, &s->bodies)) {
    s->how = TP_SETTLED_UNDECIDED;
  } else if (status == TP_OK) {
    status = tp_turning_touches(&s->touches, &turning, &s->bodies, message);
  }
  s->work += turning.pairs.looked_at + (double)s->bodies.posed.count +
             TP_REST_EXACT_LOOKS * (double)(turning.pairs.count + s->touches.count);
  tp_turning_clear(&turning);
  return status;
}

static tp_status turn_to_rest(tp_settling *s, tp_message *message) {
  const long most = tp_settle_most(s->bodies.posed.count + s->bodies.base.count);
  tp_status status = TP_OK;
  while (status == TP_OK && s->how == TP_SETTLED_RESTS) {
    tp_touch about;
    const int turn = next_turn(s, &about);
    if (turn == 0) break;
    if (s->work > s->work_allowed) {
      s->how = TP_SETTLED_TOO_DEAR;
    } else if (s->turns++ == most) {
      s->how = TP_SETTLED_GOES_ON;
    } else {
      status = turn_once(s, turn, &about, message);
    }
  }
  return status;
}

static tp_status drop_and_turn(tp_settling *s, tp_message *message) {
  bool beside = false;
  tp_candidates pairs = {0};
  s->work += (double)s->bodies.posed.count;
  tp_status status = tp_drop(s->height, &beside, &pairs, &s->bodies, &s->touches, message);
  const bool refused = is_refused(s, &pairs);
  tp_candidates_clear(&pairs);
  if (refused) return TP_OK;
  s->work += TP_REST_EXACT_LOOKS * (double)s->touches.count;
  if (status == TP_OK && beside) s->how = TP_SETTLED_BESIDE;
  if (status == TP_OK) status = turn_to_rest(s, message);
  return status;
}

tp_status tp_settle(tp_settling *settling, const tp_polyline *outline, const tp_polyline *base_ring,
                    const tp_exact_point *centroid, const fmpq_t shift_x, tp_message *message) {
  memset(settling, 0, sizeof *settling);
  settling->work_allowed = TP_BUDGET_REST_PAIRS;
  tp_status status = tp_bodies_init(&settling->bodies, outline, base_ring, centroid, message);
  if (status != TP_OK) return status;
  tp_exact_point_init(&settling->pivot);
  fmpq_init(settling->height);
  fmpq_set(settling->bodies.pose.shift_x, shift_x);
  tp_bodies_place(&settling->bodies);
  status = drop_and_turn(settling, message);
  if (status != TP_OK) tp_settling_clear(settling);
  return status;
}

tp_status tp_settle_fail_blind(tp_place place, tp_message *message) {
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, place,
      "block and profile have lengths too far apart to set the one down on the other: "
      "16 digits do not decide for any of %d pairs of corners and edges when they touch; "
      "check the lengths of both, or let the block lie where its coordinates put it, by "
      "'place: as_given'",
      TP_BUDGET_REST_BLIND);
}

tp_status tp_settle_from(tp_settling *settling, const fmpq_t shift_x, tp_message *message) {
  tp_pose *pose = &settling->bodies.pose;
  fmpq_one(pose->cosine);
  fmpq_zero(pose->sine);
  fmpq_set(pose->shift_x, shift_x);
  fmpq_zero(pose->shift_y);
  tp_bodies_place(&settling->bodies);
  settling->touches.count = 0;
  settling->touches.listed = -1;
  settling->turns = 0;
  settling->how = TP_SETTLED_RESTS;
  return drop_and_turn(settling, message);
}
