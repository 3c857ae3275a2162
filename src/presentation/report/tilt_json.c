/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A simulated tilt test and what its settings take as JSON, by the tables of core/terms/results;
 * its moments as CSV. Simulated numbers are plain: they have no proven error. */

#include "common/host.h"
#include "report/results.h"

#include <math.h>

const char *tp_json_key_of_setting(tp_converge_setting setting) {
  static const char *const keys[TP_CONVERGE_SETTINGS] = {
      [TP_CONVERGE_TOLERANCE] = "tolerance_deg",
      [TP_CONVERGE_STIFFNESS] = "normal_stiffness_pa_m",
      [TP_CONVERGE_STIFFNESS_RATIO] = "stiffness_ratio",
      [TP_CONVERGE_TIME_STEP] = "time_step_s",
      [TP_CONVERGE_DAMPING] = "damping",
      [TP_CONVERGE_ROUNDING] = "rounding_m",
      [TP_CONVERGE_STEP_TOLERANCE] = "step_tolerance",
      [TP_CONVERGE_LEAST_BOUNCE] = "least_bounce"};
  return keys[setting];
}

void tp_json_enter_tilt_case(tp_json_subject *x, const tp_tilt_case *c) {
  x->tilt_case = c;
  x->reactions = c->reactions;
  x->reaction_count = 0;
}

/* Reactions lie in the order of their moments: those of this one begin where the last ones ended.
 */
void tp_json_enter_moment(tp_json_subject *x) {
  const tp_tilt_case *c = x->tilt_case;
  size_t first = (size_t)(x->reactions - c->reactions) + x->reaction_count;
  while (first < c->reaction_count && c->reactions[first].moment < x->k) first++;
  size_t end = first;
  while (end < c->reaction_count && c->reactions[end].moment == x->k) end++;
  x->reactions = c->reactions + first;
  x->reaction_count = end - first;
}

tp_status tp_report_tilt_json(char **text, const tp_tilt_test *test) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, test);
  tp_json_subject x = {.test = test};
  return tp_json_document_of_tilt(text, test, &x);
}

tp_status tp_report_tilt_convergence_json(char **text, const tp_tilt_convergence *convergence) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, convergence);
  tp_json_subject x = {0};
  return tp_json_document_of_converge(text, convergence, &x);
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
