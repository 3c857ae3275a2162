/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory and copies of states, the choice of the frame from the facets that bear most and are
 * closed least, rates with the tilt, and the test for a jump to another equilibrium. */

#include "quasi_static/state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A step may move the block by so many times what its rates at both ends tell. Toward a limit that
 * is approached and never met displacements grow as the inverse square of what is left of the tilt:
 * half of that taken, they grow fourfold, at a rate of twice that of the old. A leap to another
 * equilibrium has no such bound: it stays as the step goes to zero. */
static const double most_leap = 16;

/* The sine of the angle between the two directions of a frame, at least: as many digits are lost.
 */
static const double least_angle = 1e-4;

static tp_xy closed_end(const tp_path_state *state, const tp_path_model *model, long k) {
  const tp_facet_state *facet = state->facets + k;
  return facet->force_from >= facet->force_to ? model->facets[k].from : model->facets[k].to;
}

bool tp_path_state_init(tp_path_state *state, const tp_path_model *model, double tilt) {
  *state =
      (tp_path_state){.tilt = tilt, .pose = {.frame = tp_path_frame_at(model->facets[0].from)}};
  state->facets = calloc((size_t)model->count, sizeof *state->facets);
  state->strains = calloc((size_t)model->count, sizeof *state->strains);
  state->lines.facets = calloc((size_t)model->count, sizeof *state->lines.facets);
  if (state->facets == NULL || state->strains == NULL || state->lines.facets == NULL) {
    tp_path_state_clear(state);
    return false;
  }
  for (long k = 0; k < model->count; k++) {
    state->strains[k] = -model->facets[k].locked_shear / model->shear_ratio;
  }
  return true;
}

void tp_path_state_clear(tp_path_state *state) {
  free(state->facets);
  free(state->strains);
  free(state->lines.facets);
  memset(state, 0, sizeof *state);
}

void tp_path_state_copy(tp_path_state *to, const tp_path_state *from, const tp_path_model *model) {
  const tp_path_state own = *to;
  memcpy(own.facets, from->facets, (size_t)model->count * sizeof *own.facets);
  memcpy(own.strains, from->strains, (size_t)model->count * sizeof *own.strains);
  *to = *from;
  to->facets = own.facets;
  to->strains = own.strains;
  to->lines = own.lines;
}

/* A contact in a point is closed in part, but wholly in its point. */
static double closed_share(const tp_path_state *state, const tp_path_model *model, long k) {
  const double closed = state->facets[k].closed;
  return model->facets[k].in_a_point ? closed * 0.99 : closed;
}

/* The facet that is closed the least, of those in part: where `beside` is given, with another
 * direction than that one. -1: none. */
static long least_closed(const tp_path_state *state, const tp_path_model *model, long beside) {
  long least = -1;
  for (long k = 0; k < model->count; k++) {
    const double closed = closed_share(state, model, k);
    if (!(closed > 0 && closed < (least < 0 ? 1 : closed_share(state, model, least)))) continue;
    if (beside >= 0 &&
        fabs(tp_xy_cross(model->facets[k].normal, model->facets[beside].normal)) < least_angle) {
      continue;
    }
    least = k;
  }
  return least;
}

/* The facet that bears the most. */
static long most_loaded(const tp_path_state *state, const tp_path_model *model) {
  long most = -1;
  double force = 0;
  for (long k = 0; k < model->count; k++) {
    const double own = state->facets[k].force_from + state->facets[k].force_to;
    if (own <= force) continue;
    most = k;
    force = own;
  }
  return most;
}

tp_path_frame tp_path_state_frame(const tp_path_state *state, const tp_path_model *model) {
  long first = least_closed(state, model, -1);
  const long second = first < 0 ? -1 : least_closed(state, model, first);
  if (first < 0) first = most_loaded(state, model);
  if (first < 0) return state->pose.frame;
  const tp_joint_facet *facet = model->facets + first;
  const tp_xy point = closed_end(state, model, first);
  return (tp_path_frame){.first = point,
                         .normal = facet->normal,
                         .second = second < 0 ? point : closed_end(state, model, second),
                         .other = second < 0 ? facet->tangent : model->facets[second].normal};
}

/* The derivative of the pose by the tilt, from K du = dF. Of stuck facets det K is above 0; where
 * it is below, the branch has turned back, and goes on towards lower tilts. */
static bool set_rate(tp_path_state *state, const tp_balance *balance) {
  tp_imbalance at;
  tp_balance_at(&at, balance, &state->pose, state->facets);
  if (!tp_matrix_is_positive(&at.stiffness)) return false;
  const tp_three load = tp_path_load_rate(balance->model, state->tilt);
  tp_three rate;
  for (int k = 0; k < 3; k++) {
    rate.of[k] = load.of[0] * state->lines.x.of[k] + load.of[1] * state->lines.y.of[k];
  }
  rate.of[2] += load.of[2];
  return tp_matrix_solve(&state->rate, &at.stiffness, &rate);
}

void tp_path_state_take(tp_path_state *state, const tp_path_pose *pose, const tp_balance *balance) {
  tp_imbalance at;
  state->pose = *pose;
  tp_balance_at(&at, balance, pose, state->facets);
  state->pose.since = (tp_three){{0}};
  for (long k = 0; k < balance->model->count; k++) state->strains[k] = state->facets[k].strain;
}

static double speed(const tp_path_state *state, const tp_path_frame *frame) {
  const tp_path_pose rate = {.frame = state->pose.frame, .moved = state->rate};
  const tp_path_pose own = tp_path_pose_in(&rate, frame);
  return tp_three_size(&own.moved);
}

static bool is_near(const tp_path_state *from, const tp_path_state *to) {
  const tp_path_frame *frame = &to->pose.frame;
  const tp_path_pose before = tp_path_pose_in(&from->pose, frame);
  double way = 0;
  for (int k = 0; k < 3; k++) way += fabs(to->pose.moved.of[k] - before.moved.of[k]);
  const double fastest = fmax(speed(from, frame), speed(to, frame));
  return way <= most_leap * (to->tilt - from->tilt) * fastest +
                    1e-9 * (1 + tp_three_size(&to->pose.moved));
}

bool tp_path_state_solve(tp_path_state *to, const tp_path_state *from, const tp_path_model *model,
                         double tilt, bool near) {
  const tp_path_frame frame = tp_path_state_frame(from, model);
  tp_path_pose pose = tp_path_pose_in(&from->pose, &frame);
  tp_path_lines_set(&to->lines, model, &frame);
  const tp_balance balance = {.model = model,
                              .lines = &to->lines,
                              .load = tp_path_load(model, tilt),
                              .strains = from->strains};
  to->tilt = tilt;
  if (!tp_balance_solve(&pose, &to->imbalance, &balance)) return false;
  to->pose = pose;
  if (!set_rate(to, &balance)) return false;
  if (near && !is_near(from, to)) return false;
  to->pose.since = (tp_three){{0}};
  for (long k = 0; k < model->count; k++) to->strains[k] = to->facets[k].strain;
  return true;
}

/* s = d + T / (r l) with T = -+ tan(phi) (A + B): its derivative along the rate of the pose. The
 * mean stress (A + B) / l is half the sum of both closures, or half that of the closed end. */
bool tp_path_slip_goes_on(const tp_path_state *state, const tp_path_model *model, long k) {
  const tp_joint_facet *facet = model->facets + k;
  const tp_facet_state *at = state->facets + k;
  const tp_facet_lines *lines = state->lines.facets + k;
  double closing = 0;
  if (at->from_closed) closing -= tp_three_product(&lines->from, &state->rate);
  if (at->to_closed && !facet->in_a_point) closing -= tp_three_product(&lines->to, &state->rate);
  const double stress_rate = facet->in_a_point ? closing : closing / 2;
  const double sign = at->shear == TP_FACET_SLIPS_ALONG ? 1 : -1;
  const double shear_rate = sign * tp_three_product(&lines->tangent, &state->rate);
  const double elastic = facet->friction * stress_rate / model->shear_ratio;
  const double scale = fabs(shear_rate) + fabs(elastic);
  return shear_rate - elastic >= -1e-9 * scale;
}
