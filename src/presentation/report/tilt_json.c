/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A simulated tilt test as JSON (docs/schema/tilt.json), its moments as CSV. Simulated numbers are
 * plain: they have no proven error. */

#include "common/host.h"
#include "output/json.h"
#include "report/notes.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>

static const double standard_gravity = 9.80665;

static void json_settings(tp_json *j, const tp_tilt_settings *s) {
  tp_json_object(j, "settings", TP_JSON_BLOCK);
  tp_json_string(j, "engine", tp_tilt_engine_name(s->engine));
  tp_json_string(j, "protocol", tp_tilt_protocol_name(s->protocol));
  tp_json_truth(j, "set_down", s->set_down);
  if (s->speed_deg_min > 0) tp_json_double(j, "speed_deg_min", s->speed_deg_min);
  if (s->protocol == TP_TILT_RELEASE) {
    tp_json_double(j, "release_deg", s->release_deg);
  } else {
    if (s->from_deg > 0) tp_json_double(j, "from_deg", s->from_deg);
    tp_json_double(j, "until_deg", s->until_deg);
    tp_json_double(j, "tolerance_deg", s->tolerance_deg);
  }
  if (s->engine == TP_TILT_RIGID) {
    tp_json_double(j, "restitution", s->restitution);
  } else {
    tp_json_double(j, "normal_stiffness_pa_m", s->normal_stiffness_pa_m);
    tp_json_double(j, "shear_stiffness_pa_m", s->shear_stiffness_pa_m);
    tp_json_truth(j, "stiffness_given", s->stiffness_given);
    if (s->traction_count > 0) tp_json_count(j, "tractions", s->traction_count);
  }
  if (s->engine == TP_TILT_SPRINGS) {
    tp_json_double(j, "damping", s->damping);
    tp_json_double(j, "rounding_m", s->rounding_m);
    tp_json_double(j, "time_step_s", s->time_step_s);
  }
  tp_json_close(j);
}

static void json_shaking(tp_json *j, const tp_tilt_test *test) {
  static const char *const names[] = {"horizontal", "vertical"};
  if (!test->shaking[0].given && !test->shaking[1].given) return;
  tp_json_object(j, "shaking", TP_JSON_BLOCK);
  for (int axis = 0; axis < 2; axis++) {
    const tp_tilt_shaking *own = test->shaking + axis;
    if (!own->given) continue;
    tp_json_object(j, names[axis], TP_JSON_LINE);
    tp_json_double(j, "peak_g", own->peak_m_s2 / standard_gravity);
    tp_json_double(j, "peak_velocity_m_s", own->velocity_m_s);
    tp_json_double(j, "last_velocity_m_s", own->last_velocity_m_s);
    tp_json_double(j, "duration_s", own->duration_s);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void json_statics(tp_json *j, const tp_tilt_case *c) {
  static const char *const places[] = {[TP_PLACE_UNKNOWN] = "unknown",
                                       [TP_PLACE_WITHIN] = "within",
                                       [TP_PLACE_BELOW] = "below the onset",
                                       [TP_PLACE_BEYOND] = "beyond the limit"};
  tp_json_object(j, "statics", TP_JSON_LINE);
  if (c->has_onset) tp_json_double(j, "onset_deg", c->onset_deg);
  if (c->has_limit) tp_json_double(j, "limit_deg", c->limit_deg);
  tp_json_string(j, "place", places[c->place]);
  tp_json_close(j);
}

static void json_critical(tp_json *j, const tp_tilt_case *c) {
  tp_json_object(j, "critical_angle_deg", TP_JSON_LINE);
  tp_json_double(j, "stands_at", c->least_deg);
  if (c->has_bracket) {
    tp_json_double(j, "lets_go_at", c->most_deg);
  } else {
    tp_json_null(j, "lets_go_at");
  }
  tp_json_truth(j, "converged", c->converged);
  tp_json_close(j);
}

static void json_mechanism(tp_json *j, const tp_tilt_case *c) {
  if (!c->has_mechanism) return;
  tp_json_string(j, "mechanism", tp_mechanism_name(c->mechanism));
  if (!c->has_centre) return;
  tp_json_double(j, "centre_x_m", c->centre_x_m);
  tp_json_double(j, "centre_y_m", c->centre_y_m);
}

static void json_path(tp_json *j, const tp_tilt_case *c) {
  if (c->has_softening) tp_json_double(j, "softening_deg", c->softening_deg);
  if (c->jumps == 0) return;
  tp_json_count(j, "jumps", c->jumps);
  tp_json_double(j, "first_jump_deg", c->first_jump_deg);
}

static void json_facets(tp_json *j, const tp_tilt_case *c) {
  tp_json_array(j, "facets", TP_JSON_LIST);
  for (size_t k = 0; k < c->facet_count; k++) {
    const tp_tilt_facet *f = c->facets + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_integer(j, "facet", f->facet);
    if (f->contact > 0) {
      tp_json_count(j, "contact", f->contact);
    } else {
      tp_json_null(j, "contact");
    }
    tp_json_double(j, "x0_m", f->x0_m);
    tp_json_double(j, "y0_m", f->y0_m);
    tp_json_double(j, "x1_m", f->x1_m);
    tp_json_double(j, "y1_m", f->y1_m);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void json_events(tp_json *j, const tp_tilt_case *c) {
  tp_json_array(j, "events", TP_JSON_LIST);
  for (size_t k = 0; k < c->event_count; k++) {
    const tp_tilt_event *e = c->events + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_string(j, "what", tp_tilt_event_name(e->kind));
    tp_json_double(j, "time_s", e->time_s);
    tp_json_double(j, "angle_deg", e->angle_deg);
    tp_json_double(j, "x_m", e->x_m);
    tp_json_double(j, "y_m", e->y_m);
    tp_json_integer(j, "facet", e->facet);
    tp_json_double(j, "speed_m_s", e->speed_m_s);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void json_moments(tp_json *j, const tp_tilt_case *c) {
  size_t reaction = 0;
  tp_json_array(j, "moments", TP_JSON_LIST);
  for (size_t k = 0; k < c->moment_count; k++) {
    const tp_tilt_moment *m = c->moments + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "time_s", m->time_s);
    tp_json_double(j, "angle_deg", m->angle_deg);
    tp_json_double(j, "moved_x_m", m->moved_x_m);
    tp_json_double(j, "moved_y_m", m->moved_y_m);
    tp_json_double(j, "turned_deg", m->turned_deg);
    tp_json_double(j, "speed_x_m_s", m->speed_x_m_s);
    tp_json_double(j, "speed_y_m_s", m->speed_y_m_s);
    tp_json_double(j, "turning_rad_s", m->turning_rad_s);
    tp_json_double(j, "kinetic_energy_j", m->kinetic_energy_j);
    tp_json_double(j, "energy_balance_j", m->energy_balance_j);
    tp_json_array(j, "reactions", TP_JSON_LINE);
    while (reaction < c->reaction_count && c->reactions[reaction].moment < k) reaction++;
    for (; reaction < c->reaction_count && c->reactions[reaction].moment == k; reaction++) {
      tp_json_object(j, NULL, TP_JSON_LINE);
      tp_json_integer(j, "facet", c->reactions[reaction].facet);
      tp_json_double(j, "normal_n", c->reactions[reaction].normal_n);
      tp_json_double(j, "shear_n", c->reactions[reaction].shear_n);
      tp_json_close(j);
    }
    tp_json_close(j);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void json_overturning(tp_json *j, const tp_tilt_case *c) {
  if (c->has_overturning) {
    tp_json_object(j, "overturning_factor", TP_JSON_LINE);
    tp_json_double(j, "spared_by", c->overturning_least);
    tp_json_double(j, "overturned_by", c->overturning_most);
    tp_json_close(j);
  }
  tp_json_array(j, "overturning_tried", TP_JSON_LIST);
  for (size_t k = 0; k < c->overturning_grid_count; k++) {
    const tp_overturning_grid *grid = c->overturning_grids + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "from", grid->least);
    tp_json_double(j, "to", grid->most);
    tp_json_count(j, "count", grid->count);
    tp_json_close(j);
  }
  tp_json_close(j);
  tp_json_array(j, "overturning_ranges", TP_JSON_LIST);
  for (size_t k = 0; k < c->overturning_range_count; k++) {
    const tp_overturning_range *range = c->overturning_ranges + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "spared_below", range->spared_below);
    tp_json_double(j, "least", range->least);
    tp_json_double(j, "most", range->most);
    tp_json_double(j, "spared_above", range->spared_above);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void json_case(tp_json *j, const tp_tilt_case *c, const tp_tilt_test *test) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "towards", tp_direction_name(c->towards));
  if (test->settings.protocol != TP_TILT_RELEASE) json_critical(j, c);
  json_path(j, c);
  json_mechanism(j, c);
  json_statics(j, c);
  tp_json_string(j, "end", tp_tilt_end_name(c->end));
  tp_json_double(j, "ended_s", c->ended_s);
  tp_json_double(j, "ended_deg", c->ended_deg);
  tp_json_double(j, "run_out_m", c->run_out_m);
  tp_json_double(j, "turned_deg", c->turned_deg);
  tp_json_double(j, "kinetic_energy_j", c->kinetic_energy_j);
  tp_json_double(j, "energy_balance_j", c->energy_balance_j);
  tp_json_double(j, "energy_scale_j", c->energy_scale_j);
  if (c->overturning_scanned) json_overturning(j, c);
  json_facets(j, c);
  json_events(j, c);
  json_moments(j, c);
  tp_json_count(j, "runs", c->runs);
  tp_json_double(j, "seconds", c->seconds);
  tp_json_close(j);
}

tp_status tp_report_tilt_json(char **text, const tp_tilt_test *test) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, test);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_string(&j, "title", test->title);
  json_settings(&j, &test->settings);
  json_shaking(&j, test);
  tp_json_array(&j, "cases", TP_JSON_LIST);
  for (size_t k = 0; k < test->case_count; k++) json_case(&j, test->cases + k, test);
  tp_json_close(&j);
  tp_json_notes(&j, &test->notes);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}

tp_status tp_report_tilt_csv(char **text, const tp_tilt_test *test) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, test);
  tp_text t = {0};
  tp_text_add(&t, "towards,time_s,angle_deg,moved_x_m,moved_y_m,turned_deg,speed_x_m_s,"
                  "speed_y_m_s,turning_rad_s,kinetic_energy_j,energy_balance_j\n");
  for (size_t c = 0; c < test->case_count; c++) {
    const tp_tilt_case *own = test->cases + c;
    for (size_t k = 0; k < own->moment_count; k++) {
      const tp_tilt_moment *m = own->moments + k;
      tp_text_add(&t, "%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,",
                  tp_direction_name(own->towards), m->time_s, m->angle_deg, m->moved_x_m,
                  m->moved_y_m, m->turned_deg, m->speed_x_m_s, m->speed_y_m_s, m->turning_rad_s,
                  m->kinetic_energy_j);
      /* a path has none */
      if (!isnan(m->energy_balance_j)) tp_text_add(&t, "%.17g", m->energy_balance_j);
      tp_text_add(&t, "\n");
    }
  }
  return tp_text_finish(&t, text);
}
