/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* State of a panel: the tilt that it shows, reactions at the limit and their resultant, whose line
 * passes through the point where theirs meet. */

#include "figure/figure.h"

#include <math.h>
#include <string.h>

#define ARROW 0.3 /* of the weight's arrow, in units of the block's size */

/* Points nearer than this are one on the page. */
#define SAME 1e-7

static bool same(tp_spot p, tp_spot q) {
  return hypot(p.x - q.x, p.y - q.y) < SAME;
}

static void choose_tilt(tp_state *state, const tp_figure *figure) {
  const tp_case *own = state->own;
  const tp_solution *solution = figure->solution;
  if (solution->frame.world && solution->has_tilt_angle) {
    state->kind = TP_STATE_LIES;
    state->tilt_deg = solution->tilt_angle_deg;
    return;
  }
  if (own->limit.kind == TP_LIMIT_AT_ANGLE) {
    state->kind = TP_STATE_LIMIT;
    state->tilt_deg = own->limit.critical_angle_deg;
    return;
  }
  if (own->limit.kind == TP_LIMIT_NOT_ASKED && own->has_toppling_pivot) {
    const tp_pivot *pivot = own->pivots + own->toppling_pivot;
    const double angle = pivot->critical_angle_deg.value;
    if (!pivot->never && !pivot->always && angle > 0 && angle < 90) {
      state->kind = TP_STATE_MOMENTS;
      state->tilt_deg = pivot->critical_angle_deg;
      return;
    }
  }
  state->kind = solution->has_tilt_angle ? TP_STATE_SCENE : TP_STATE_LEVEL;
  if (solution->has_tilt_angle) state->tilt_deg = solution->tilt_angle_deg;
}

/* The reactions; two in one point are one. */
static void take_reactions(tp_state *state, const tp_figure *figure) {
  const tp_limit *limit = &state->own->limit;
  if (state->kind != TP_STATE_LIMIT) return;
  for (size_t k = 0; k < limit->reaction_count; k++) {
    const tp_reaction *r = limit->reactions + k;
    const tp_force force = {tp_shape_of_metres(&figure->shape, r->x_m, r->y_m),
                            {r->share_x.value, r->share_y.value},
                            {.value = hypot(r->share_x.value, r->share_y.value),
                             .error = r->share_x.error + r->share_y.error}};
    tp_force *first = state->reactions;
    if (state->reaction_count == 1 && same(first->at, force.at)) {
      first->share = (tp_spot){first->share.x + force.share.x, first->share.y + force.share.y};
      first->size.value = hypot(first->share.x, first->share.y);
      first->size.error += force.size.error;
    } else {
      state->reactions[state->reaction_count++] = force;
    }
  }
}

/* Against the reactions, on a line through the point where theirs meet, or the one of both. */
static void find_resultant(tp_state *state) {
  const tp_force *r = state->reactions;
  tp_spot sum = r[0].share, on = r[0].at;
  if (state->reaction_count == 2) {
    sum = (tp_spot){sum.x + r[1].share.x, sum.y + r[1].share.y};
    if (!tp_spot_meet(&on, r[0].at, r[0].share, r[1].at, r[1].share)) {
      const double share = r[1].size.value / (r[0].size.value + r[1].size.value);
      on = (tp_spot){r[0].at.x + share * (r[1].at.x - r[0].at.x),
                     r[0].at.y + share * (r[1].at.y - r[0].at.y)};
    }
  }
  const double square = sum.x * sum.x + sum.y * sum.y;
  const tp_spot g = state->centroid;
  const double along = ((g.x - on.x) * sum.x + (g.y - on.y) * sum.y) / square;
  state->has_resultant = square > 0;
  state->resultant =
      (tp_force){.at = {on.x + along * sum.x, on.y + along * sum.y}, .share = {-sum.x, -sum.y}};
}

static void find_forces_at_limit(tp_state *state, const tp_figure *figure) {
  tp_force *r = state->reactions;
  take_reactions(state, figure);
  if (state->reaction_count == 2 && r[1].at.x < r[0].at.x) {
    const tp_force first = r[1];
    r[1] = r[0];
    r[0] = first;
  }
  if (state->reaction_count == 0) return;
  if (figure->solution->loaded) find_resultant(state);
  if (state->reaction_count == 2) {
    state->meets = tp_spot_meet(&state->meeting, r[0].at, r[0].share, r[1].at, r[1].share) &&
                   tp_figure_in_sight(figure, state->meeting);
  }
}

/* So long that all arrows have room. */
static void set_arrow(tp_state *state) {
  const tp_force *r = state->reactions;
  double largest = 1;
  for (size_t k = 0; k < state->reaction_count; k++) largest = fmax(largest, r[k].size.value);
  const double resultant = hypot(state->resultant.share.x, state->resultant.share.y);
  state->arrow = ARROW * fmin(1, 1.4 / fmax(largest, resultant));
  if (state->reaction_count != 1) return;
  /* on one line: the two arrows that meet in the pivot stay apart */
  const tp_spot from = state->has_resultant ? state->resultant.at : state->centroid;
  const double apart = hypot(from.x - r[0].at.x, from.y - r[0].at.y);
  if (apart > 0.1 * ARROW) state->arrow = fmin(state->arrow, 0.75 * apart / fmax(resultant, 1));
}

bool tp_state_init(tp_state *state, const tp_figure *figure, const tp_case *own) {
  const tp_block_result *block = &figure->solution->block;
  memset(state, 0, sizeof *state);
  state->own = own;
  state->arrow = ARROW;
  choose_tilt(state, figure);
  state->turn = state->tilt_deg.value * atan(1) / 45;
  if (own->towards == TP_TOWARDS_RIGHT) state->turn = -state->turn;
  state->gravity = (tp_spot){-sin(state->turn), -cos(state->turn)};
  state->centroid = tp_shape_of_metres(&figure->shape, block->centroid_x_m, block->centroid_y_m);
  if (state->kind == TP_STATE_LIES) {
    if (!tp_state_find_present(state, figure)) return false;
  } else {
    find_forces_at_limit(state, figure);
  }
  if (state->reaction_count > 0 || state->has_resultant) set_arrow(state);
  if (state->kind != TP_STATE_LIMIT || !own->limit.has_centre) return true;
  state->has_centre = true;
  state->centre = tp_shape_of_metres(&figure->shape, own->limit.centre_x_m, own->limit.centre_y_m);
  state->shows_centre = tp_figure_in_sight(figure, state->centre);
  return true;
}

tp_spot tp_figure_pivot_spot(const tp_figure *figure, const tp_case *own, size_t pivot) {
  return tp_shape_of_metres(&figure->shape, own->pivots[pivot].x_m, own->pivots[pivot].y_m);
}

size_t tp_state_pivot_at(const tp_figure *figure, const tp_state *state, tp_spot at) {
  for (size_t k = 0; k < state->own->pivot_count; k++) {
    if (same(tp_figure_pivot_spot(figure, state->own, k), at)) return k + 1;
  }
  return 0;
}

/* Keep the list in order and without a pivot twice. */
static size_t insert(size_t *listed, size_t count, size_t pivot) {
  size_t at = 0;
  while (at < count && listed[at] < pivot) at++;
  if (count == TP_PIVOTS_LISTED || (at < count && listed[at] == pivot)) return count;
  memmove(listed + at + 1, listed + at, (count - at) * sizeof *listed);
  listed[at] = pivot;
  return count + 1;
}

size_t tp_state_pivots(size_t listed[TP_PIVOTS_LISTED], const tp_figure *figure,
                       const tp_state *state) {
  const tp_case *own = state->own;
  size_t count = 0;
  if (own->has_toppling_pivot) count = insert(listed, count, own->toppling_pivot);
  for (size_t k = 0; k < state->reaction_count; k++) {
    const size_t number = tp_state_pivot_at(figure, state, state->reactions[k].at);
    if (number > 0) count = insert(listed, count, number - 1);
  }
  for (size_t k = 0; k < own->pivot_count && count < TP_PIVOTS_LISTED; k++) {
    if (own->pivots[k].admissible) count = insert(listed, count, k);
  }
  for (size_t k = 0; k < own->pivot_count && count < TP_PIVOTS_LISTED; k++) {
    const size_t toe = own->towards == TP_TOWARDS_LEFT ? k : own->pivot_count - 1 - k;
    count = insert(listed, count, toe);
  }
  return count;
}
