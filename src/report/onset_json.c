/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key `onset`: from which tilt on a motion can begin, and which, as JSON (docs/onset.md). */

#include "report/onset.h"

#include "output/json.h"
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

static void add_end(tp_text *t, const char *key, bool endless, tp_bounded degrees) {
  if (endless) {
    tp_text_add(t, "\"%s\": null", key);
  } else {
    tp_json_number(t, key, degrees);
  }
}

static void add_windows(tp_text *t, const tp_onset *o) {
  tp_text_add(t, ",\n        \"windows\": [");
  for (size_t k = 0; k < o->window_count; k++) {
    const tp_window *w = o->windows + k;
    tp_text_add(t, "%s\n          {", k > 0 ? "," : "");
    add_end(t, "from_deg", w->from_below, w->from_deg);
    tp_text_add(t, ", ");
    add_end(t, "to_deg", w->to_above, w->to_deg);
    tp_text_add(t, ", \"begins\": \"%s\"}", tp_text_mechanism(w->begins));
  }
  tp_text_add(t, "]");
}

static void add_contact(tp_text *t, const tp_motion_contact *c) {
  tp_text_add(t, "{\"facet\": ");
  if (c->of_facet) {
    tp_text_add(t, "%zu, \"end\": \"%s\"", c->facet, c->at_right_end ? "right" : "left");
  } else {
    tp_text_add(t, "null");
  }
  tp_text_add(t, ", \"state\": \"%s\"", tp_text_contact_state(c->state));
  if (c->has_force) {
    tp_text_add(t, ", ");
    tp_json_number(t, "share_x", c->share_x);
    tp_text_add(t, ", ");
    tp_json_number(t, "share_y", c->share_y);
  }
  tp_text_add(t, "}");
}

static void add_resistance(tp_text *t, const char *key, const tp_motion_resistance *r) {
  tp_text_add(t, "\"%s\": {", key);
  tp_json_number(t, "share_x", r->share_x);
  tp_text_add(t, ", ");
  tp_json_number(t, "share_y", r->share_y);
  tp_text_add(t, ", ");
  tp_json_number(t, "moment_m", r->moment_m);
  tp_text_add(t, "}");
}

static void add_motion(tp_text *t, const tp_motion *m) {
  tp_text_add(t, "{\"mechanism\": \"%s\", ", tp_text_mechanism(m->mechanism));
  tp_json_number(t, "acceleration_x_g", m->acceleration_x_g);
  tp_text_add(t, ", ");
  tp_json_number(t, "acceleration_y_g", m->acceleration_y_g);
  tp_text_add(t, ", ");
  tp_json_number(t, "angular_g_per_m", m->angular_g_per_m);
  tp_text_add(t, ", \"accelerations_fixed\": %s", tp_json_truth(m->accelerations_fixed));
  if (m->has_centre) {
    tp_text_add(t, ", ");
    tp_json_number(t, "centre_x_m", m->centre_x_m);
    tp_text_add(t, ", ");
    tp_json_number(t, "centre_y_m", m->centre_y_m);
  }
  if (m->has_strength) {
    tp_text_add(t, ",\n          \"overcomes\": {");
    add_resistance(t, "cohesion", &m->cohesion);
    tp_text_add(t, ", ");
    add_resistance(t, "bond", &m->bond);
    tp_text_add(t, "}");
  }
  tp_text_add(t, ",\n          \"contacts\": [");
  for (size_t k = 0; k < m->contact_count; k++) {
    tp_text_add(t, "%s", k > 0 ? ",\n            " : "");
    add_contact(t, m->contacts + k);
  }
  tp_text_add(t, "]}");
}

static void add_motions(tp_text *t, const tp_onset *o) {
  if (!o->has_motions) return;
  tp_text_add(t, "      \"motions\": [");
  for (size_t k = 0; k < o->motion_count; k++) {
    tp_text_add(t, "%s\n        ", k > 0 ? "," : "");
    add_motion(t, o->motions + k);
  }
  tp_text_add(t, "],\n");
}

void tp_json_onset(tp_text *t, const tp_case *c) {
  const tp_onset *o = &c->onset;
  if (o->kind == TP_ONSET_NOT_ASKED) return;
  tp_text_add(t, "      \"onset\": {\"kind\": \"%s\", ", kind_of(o->kind));
  tp_json_number(t, "friction_angle_deg", o->friction_angle_deg);
  tp_text_add(t, ", ");
  add_end(t, "critical_angle_deg", o->kind != TP_ONSET_AT_ANGLE, o->critical_angle_deg);
  tp_text_add(t, ", \"mechanism\": \"%s\"", tp_text_mechanism(o->mechanism));
  if (o->tie) tp_text_add(t, ", \"tied_with\": \"%s\"", tp_text_mechanism(o->tied_with));
  tp_json_tie(t, o->tie, o->tie_bits);
  if (o->kind == TP_ONSET_UNDECIDED) {
    tp_text_add(t, ", \"too_dear\": %s", tp_json_truth(o->too_dear));
  }
  if (o->has_centre) {
    tp_text_add(t, ", ");
    tp_json_number(t, "centre_x_m", o->centre_x_m);
    tp_text_add(t, ", ");
    tp_json_number(t, "centre_y_m", o->centre_y_m);
  }
  tp_text_add(t, ", \"below_limit\": %s", tp_json_truth(o->below_limit));
  if (o->has_motions) tp_text_add(t, ", \"paradox\": %s", tp_json_truth(o->paradox));
  add_windows(t, o);
  tp_text_add(t, "},\n");
  add_motions(t, o);
}

void tp_json_beginnings(tp_text *t, const tp_case *c) {
  const tp_onset *o = &c->onset;
  tp_text_add(t, "      \"can_begin\": ");
  if (!o->has_motions) {
    tp_text_add(t, "null,\n");
    return;
  }
  tp_text_add(t, "[");
  for (size_t k = 0; k < o->beginning_count; k++) {
    tp_text_add(t, "%s\"%s\"", k > 0 ? ", " : "", tp_text_mechanism(o->beginnings[k]));
  }
  tp_text_add(t, "],\n");
}
