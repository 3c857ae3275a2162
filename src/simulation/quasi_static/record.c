/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Differences of two neighbouring states as events of contact ends and facets, and a state as a
 * moment with reactions. */

#include "quasi_static/record.h"

#include <math.h>

static double degrees(double radians) {
  return radians * (180 / acos(-1));
}

static const tp_facet_state at_rest = {
    .from_closed = true, .to_closed = true, .shear = TP_FACET_STICKS};

static bool slips(const tp_facet_state *state) {
  return state->shear == TP_FACET_SLIPS_ALONG || state->shear == TP_FACET_SLIPS_AGAINST;
}

/* A facet that is open neither slips nor sticks: that it opens or closes says all. */
static bool starts_to_slip(const tp_facet_state *before, const tp_facet_state *after) {
  return slips(after) && before->shear != after->shear;
}

static bool starts_to_stick(const tp_facet_state *before, const tp_facet_state *after) {
  return slips(before) && after->shear == TP_FACET_STICKS;
}

bool tp_path_states_differ(const tp_path_state *before, const tp_path_state *after,
                           const tp_path_model *model) {
  for (long k = 0; k < model->count; k++) {
    const tp_facet_state *a = before->facets + k, *b = after->facets + k;
    if (a->from_closed != b->from_closed || a->to_closed != b->to_closed || a->shear != b->shear) {
      return true;
    }
  }
  return false;
}

/* An event of a facet at a point of it; the history, where there is one, is told. */
typedef struct told {
  tp_history *history;
  long *count;
  const tp_path_model *model;
  double tilt;
  bool memory;
} told;

static void tell(told *t, tp_tilt_event_kind kind, const tp_joint_facet *facet, tp_xy at) {
  const tp_rigid_body *body = t->model->body;
  ++*t->count;
  if (t->history == NULL) return;
  t->memory =
      t->memory &&
      tp_history_event(t->history, (tp_tilt_event){.what = kind,
                                                   .angle_deg = degrees(t->tilt),
                                                   .x_m = body->origin.x + at.x * body->extent_m,
                                                   .y_m = body->origin.y + at.y * body->extent_m,
                                                   .facet = facet->number});
}

static void tell_end(told *t, const tp_joint_facet *facet, tp_xy at, bool was, bool is) {
  if (was != is) tell(t, is ? TP_EVENT_CLOSES : TP_EVENT_OPENS, facet, at);
}

/* Where the normal force acts. */
static tp_xy centre_of_pressure(const tp_joint_facet *facet, const tp_facet_state *state) {
  const double force = state->force_from + state->force_to;
  const double share = force > 0 ? state->force_to / force : 0.5;
  return tp_xy_plus(facet->from, share, tp_xy_minus(facet->to, facet->from));
}

bool tp_path_record_events(tp_history *history, long *count, const tp_path_state *before,
                           const tp_path_state *after, const tp_path_model *model) {
  told t = {
      .history = history, .count = count, .model = model, .tilt = after->tilt, .memory = true};
  for (long k = 0; k < model->count; k++) {
    const tp_joint_facet *facet = model->facets + k;
    const tp_facet_state *was = before == NULL ? &at_rest : before->facets + k,
                         *is = after->facets + k;
    tell_end(&t, facet, facet->from, was->from_closed, is->from_closed);
    if (!facet->in_a_point) tell_end(&t, facet, facet->to, was->to_closed, is->to_closed);
    if (starts_to_slip(was, is)) tell(&t, TP_EVENT_SLIPS, facet, centre_of_pressure(facet, is));
    if (starts_to_stick(was, is)) tell(&t, TP_EVENT_STICKS, facet, centre_of_pressure(facet, is));
  }
  return t.memory;
}

/* Contacts one after the other on one facet of the base are told as one. */
static bool record_reactions(tp_history *history, const tp_path_state *state,
                             const tp_path_model *model) {
  double normal = 0, shear = 0;
  for (long k = 0; k < model->count; k++) {
    const tp_joint_facet *facet = model->facets + k;
    const tp_facet_state *own = state->facets + k;
    normal += (own->force_from + own->force_to) * model->weight_n;
    shear += own->shear_force * model->weight_n;
    if (k + 1 < model->count && facet[1].number == facet->number) continue;
    if (!tp_history_reaction(history, facet->number, normal, shear)) return false;
    normal = shear = 0;
  }
  return true;
}

bool tp_path_record_moment(tp_history *history, const tp_path_state *state,
                           const tp_path_model *model) {
  if (history == NULL) return true;
  const double unit = model->closure_m;
  const tp_three moved = tp_path_pose_of_centroid(&state->pose);
  const tp_tilt_moment moment = {.angle_deg = degrees(state->tilt),
                                 .moved_x_m = moved.of[0] * unit,
                                 .moved_y_m = moved.of[1] * unit,
                                 .turned_deg = degrees(moved.of[2] * unit / model->body->extent_m),
                                 .energy_balance_j = NAN};
  return tp_history_moment(history, moment) && record_reactions(history, state, model);
}

bool tp_path_record_collapse(tp_history *history, double tilt, const tp_path_model *model) {
  if (history == NULL) return true;
  return tp_history_event(history, (tp_tilt_event){.what = TP_EVENT_COLLAPSES,
                                                   .angle_deg = degrees(tilt),
                                                   .x_m = model->body->origin.x,
                                                   .y_m = model->body->origin.y});
}
