/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key `onset`: from which tilt on a motion can begin, and which, as JSON (docs/onset.md). */

#include "report/onset.h"

#include "report/parts_json.h"
#include "report/words.h"

static const char *kind_of(tp_onset_kind kind) {
  switch (kind) {
  case TP_ONSET_AT_ANGLE:
    return "angle";
  case TP_ONSET_NEVER:
    return "never";
  case TP_ONSET_NOWHERE:
    return "nowhere";
  case TP_ONSET_NOT_ASKED:
  case TP_ONSET_UNDECIDED:
    break;
  }
  return "undecided";
}

static void add_windows(tp_json *j, const tp_onset *o) {
  tp_json_break(j);
  tp_json_array(j, "windows", TP_JSON_LIST);
  for (size_t k = 0; k < o->window_count; k++) {
    const tp_window *w = o->windows + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_known(j, "from_deg", !w->from_below, w->from_deg);
    tp_json_known(j, "to_deg", !w->to_above, w->to_deg);
    tp_json_string(j, "begins", tp_mechanism_name(w->begins));
    tp_json_truth(j, "from_by_strength", w->from_by_strength);
    tp_json_truth(j, "to_by_strength", w->to_by_strength);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_contact(tp_json *j, const tp_motion_contact *c) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  if (c->of_facet) {
    tp_json_count(j, "facet", c->facet);
    tp_json_string(j, "end", c->at_right_end ? "right" : "left");
  } else {
    tp_json_null(j, "facet");
  }
  tp_json_string(j, "state", tp_text_contact_state(c->state));
  if (c->has_force) {
    tp_json_bounded(j, "share_x", c->share_x);
    tp_json_bounded(j, "share_y", c->share_y);
  }
  tp_json_close(j);
}

static void add_contacts(tp_json *j, const tp_motion *m) {
  tp_json_break(j);
  tp_json_array(j, "contacts", TP_JSON_LINE);
  for (size_t k = 0; k < m->contact_count; k++) {
    if (k > 0) tp_json_break(j);
    add_contact(j, m->contacts + k);
  }
  tp_json_close(j);
}

static void add_resistance(tp_json *j, const char *key, const tp_motion_resistance *r) {
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_bounded(j, "share_x", r->share_x);
  tp_json_bounded(j, "share_y", r->share_y);
  tp_json_bounded(j, "moment_m", r->moment_m);
  tp_json_close(j);
}

static void add_motion(tp_json *j, const tp_motion *m) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "mechanism", tp_mechanism_name(m->mechanism));
  tp_json_bounded(j, "acceleration_x_g", m->acceleration_x_g);
  tp_json_bounded(j, "acceleration_y_g", m->acceleration_y_g);
  tp_json_bounded(j, "angular_g_per_m", m->angular_g_per_m);
  tp_json_truth(j, "accelerations_fixed", m->accelerations_fixed);
  if (m->has_centre) {
    tp_json_bounded(j, "centre_x_m", m->centre_x_m);
    tp_json_bounded(j, "centre_y_m", m->centre_y_m);
  }
  if (m->has_strength) {
    tp_json_break(j);
    tp_json_object(j, "overcomes", TP_JSON_LINE);
    add_resistance(j, "cohesion", &m->cohesion);
    add_resistance(j, "bond", &m->bond);
    tp_json_close(j);
  }
  add_contacts(j, m);
  tp_json_close(j);
}

static void add_motions(tp_json *j, const tp_onset *o) {
  if (!o->has_motions) return;
  tp_json_array(j, "motions", TP_JSON_LIST);
  for (size_t k = 0; k < o->motion_count; k++) add_motion(j, o->motions + k);
  tp_json_close(j);
}

void tp_json_onset(tp_json *j, const tp_case *c) {
  const tp_onset *o = &c->onset;
  if (o->kind == TP_ONSET_NOT_ASKED) return;
  tp_json_object(j, "onset", TP_JSON_LINE);
  tp_json_string(j, "kind", kind_of(o->kind));
  tp_json_bounded(j, "friction_angle_deg", o->friction_angle_deg);
  tp_json_known(j, "critical_angle_deg", o->kind == TP_ONSET_AT_ANGLE, o->critical_angle_deg);
  tp_json_string(j, "mechanism", tp_mechanism_name(o->mechanism));
  if (o->tie) tp_json_string(j, "tied_with", tp_mechanism_name(o->tied_with));
  tp_json_tie(j, o->tie, o->tie_bits);
  if (o->kind == TP_ONSET_UNDECIDED) tp_json_truth(j, "too_dear", o->too_dear);
  if (o->has_centre) {
    tp_json_bounded(j, "centre_x_m", o->centre_x_m);
    tp_json_bounded(j, "centre_y_m", o->centre_y_m);
  }
  tp_json_truth(j, "below_limit", o->below_limit);
  if (o->has_motions) tp_json_truth(j, "paradox", o->paradox);
  if (o->fos.state != TP_FOS_NOT_ASKED && o->fos.state != TP_FOS_NO_TILT) {
    if (o->fos.state == TP_FOS_UNDEFINED) {
      tp_json_no_fos(j, "fos", "none: not certain to stand at any strength");
    } else {
      tp_json_fos(j, "fos", o->fos);
    }
  }
  add_windows(j, o);
  tp_json_close(j);
  add_motions(j, o);
}

void tp_json_beginnings(tp_json *j, const tp_case *c) {
  const tp_onset *o = &c->onset;
  if (!o->has_motions) {
    tp_json_null(j, "can_begin");
    return;
  }
  tp_json_array(j, "can_begin", TP_JSON_LINE);
  for (size_t k = 0; k < o->beginning_count; k++) {
    tp_json_string(j, NULL, tp_mechanism_name(o->beginnings[k]));
  }
  tp_json_close(j);
}
