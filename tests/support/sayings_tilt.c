/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls on simulated tilt tests say, of scenes built by every call that they have: the
 * same bits whatever the program has set, and in every thread. */

#include "sayings.h"

#include <stdio.h>

#define E(number) tp_exact_of(number)
#define T(text) tp_exact_text(text)
#define SAY(call) note_status(s, call, &message)

static const double slab[] = {0, 0, 1, 0, 1, 3, 0, 3};
static const char *const shakes[] = {"0", "0", "0.1", "0.25", "0.2", "-1/5", "0.3", "0"};

static void say_drawn(sayings *s, const tp_tilt_test *test) {
  tp_message message = {.text = ""};
  char path[400];
  snprintf(path, sizeof path, "%s/tilt.svg", s->folder);
  SAY(tp_report_tilt_file(path, test, true, &message));
  say_file(s, path);
}

static void say_sheet(sayings *s, const tp_scene *scene, const tp_tilt_test *test) {
  tp_message message = {.text = ""};
  char path[400];
  tp_sheet_options options = tp_sheet_options_default();
  options.times = 0;
  snprintf(path, sizeof path, "%s/tilt.md", s->folder);
  SAY(tp_report_sheet_tilt(path, scene, test, &options, &message));
  say_file(s, path);
}

static void say_charts(sayings *s, const tp_tilt_test *test) {
  tp_message message = {.text = ""};
  tp_chart *charts[2] = {NULL, NULL};
  SAY(tp_chart_tilt_reactions(charts, test, &message));
  SAY(tp_chart_tilt_phase(charts + 1, test, &message));
  for (size_t k = 0; k < 2; k++) {
    if (charts[k] == NULL) continue;
    if (tp_report_chart_csv(next_saying(s), charts[k]) != TP_OK) s->count--;
    tp_chart_free(charts[k]);
  }
}

static void say_test(sayings *s, const tp_scene *scene, bool overturning) {
  tp_message message = {.text = ""};
  tp_tilt_test *test = NULL;
  tp_tilt_options options = tp_tilt_options_default();
  options.moments = 20;
  options.overturning = overturning;
  SAY(tp_tilt_test_run(&test, scene, &options, &message));
  if (test == NULL) return;
  for (size_t k = 0; k < test->case_count; k++) test->cases[k].seconds = 0;
  if (tp_report_tilt(next_saying(s), test) != TP_OK) s->count--;
  if (tp_report_tilt_json(next_saying(s), test) != TP_OK) s->count--;
  if (tp_report_tilt_csv(next_saying(s), test) != TP_OK) s->count--;
  if (tp_report_tilt_frames(next_saying(s), test) != TP_OK) s->count--;
  if (tp_report_tilt_animation(next_saying(s), test) != TP_OK) s->count--;
  say_drawn(s, test);
  say_sheet(s, scene, test);
  say_charts(s, test);
  tp_tilt_test_free(test);
}

/* But for what it takes. */
static void say_convergence(sayings *s, const tp_scene *scene) {
  tp_message message = {.text = ""};
  tp_tilt_convergence *convergence = NULL;
  tp_chart *chart = NULL;
  const tp_tilt_options options = tp_tilt_options_default();
  SAY(tp_tilt_converge(&convergence, scene, &options, &message));
  if (convergence == NULL) return;
  for (size_t k = 0; k < convergence->case_count; k++) {
    const tp_tilt_convergence_case *own = convergence->cases + k;
    for (size_t l = 0; l < own->level_count; l++) own->levels[l].seconds = 0.00123456789;
  }
  if (tp_report_tilt_convergence(next_saying(s), convergence) != TP_OK) s->count--;
  if (tp_report_tilt_convergence_json(next_saying(s), convergence) != TP_OK) s->count--;
  SAY(tp_chart_tilt_convergence(&chart, convergence, &message));
  if (chart != NULL && tp_report_chart_csv(next_saying(s), chart) != TP_OK) s->count--;
  tp_chart_free(chart);
  tp_tilt_convergence_free(convergence);
}

static void say_tilted(sayings *s, tp_scene *scene) {
  tp_message message = {.text = ""};
  SAY(tp_scene_set_tilt_test(scene, TP_TILT_PATH, TP_TILT_RAMP, false, &message));
  SAY(tp_scene_set_number(scene, "tilt_test.until_deg", E(60.5), &message));
  SAY(tp_scene_set_number(scene, "tilt_test.tolerance_deg", T("0.05"), &message));
  say_test(s, scene, false);
  say_convergence(s, scene);
  SAY(tp_scene_add_tilt_test_traction(scene, 1, E(1.5), T("0.25"), E(-0.5), &message));
  SAY(tp_scene_add_tilt_test_traction(scene, 0, E(1), E(1), E(1), &message));
  SAY(tp_scene_set_tilt_test(scene, TP_TILT_RIGID, TP_TILT_STEPS, true, &message));
  SAY(tp_scene_set_number(scene, "tilt_test.restitution", T("0.25"), &message));
  SAY(tp_scene_set_number(scene, "tilt_test.duration_s", E(1.5), &message));
  say_test(s, scene, false);
}

/* Those of springs, and what does not go together. */
static void say_springs(sayings *s, tp_scene *scene) {
  tp_message message = {.text = ""};
  SAY(tp_scene_set_tilt_test(scene, TP_TILT_SPRINGS, TP_TILT_RELEASE, true, &message));
  SAY(tp_scene_set_tilt_angle_deg(scene, E(25), &message));
  SAY(tp_scene_set_number(scene, "tilt_test.duration_s", T("0.01"), &message));
  SAY(tp_scene_set_tilt_test_stiffness_gpa_m(scene, E(1), T("0.5"), &message));
  SAY(tp_scene_set_number(scene, "tilt_test.damping", E(0.75), &message));
  SAY(tp_scene_set_number(scene, "tilt_test.rounding", T("1e-5"), &message));
  say_test(s, scene, false);
  SAY(tp_scene_set_number(scene, "tilt_test.time_step_s", E(1.5), &message));
  say_test(s, scene, false);
  SAY(tp_scene_set_number(scene, "tilt_test.speed_deg_min", E(20.5), &message));
  say_test(s, scene, false);
}

static tp_scene *begin(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  SAY(tp_scene_new(&scene, "m", &message));
  if (scene == NULL) return NULL;
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(slab, 4), &message));
  SAY(tp_scene_set_unit_weight_kn_m3(scene, E(25.5), &message));
  SAY(tp_scene_set_friction_angle_deg(scene, E(40.5), &message));
  SAY(tp_scene_set_tilt_towards(scene, true, false, &message));
  return scene;
}

static void say_spectrum(sayings *s, const tp_scene *scene) {
  tp_message message = {.text = ""};
  tp_chart *chart = NULL;
  tp_overturning_options options = tp_overturning_options_default();
  options.from = 0.75;
  options.to = 1.5;
  options.count = 2;
  SAY(tp_chart_overturning(&chart, scene, &options, &message));
  if (chart != NULL && tp_report_chart_csv(next_saying(s), chart) != TP_OK) s->count--;
  tp_chart_free(chart);
}

static void say_shaken(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = begin(s);
  if (scene == NULL) return;
  SAY(tp_scene_set_shaking_pulse(scene, TP_SHAKES_HORIZONTALLY, TP_PULSE_HALF_SINE, T("0.5"),
                                 E(1.5), &message));
  SAY(tp_scene_set_shaking_record(scene, TP_SHAKES_VERTICALLY, tp_coordinates_text(shakes, 4),
                                  E(0.5), &message));
  SAY(tp_scene_set_number(scene, "tilt_test.duration_s", E(0.5), &message));
  say_test(s, scene, false);
  say_spectrum(s, scene);
  tp_scene_free(scene);
}

void say_tilts(sayings *s) {
  tp_scene *scene = begin(s);
  if (scene == NULL) return;
  say_tilted(s, scene);
  tp_scene_free(scene);
  scene = begin(s);
  if (scene == NULL) return;
  say_springs(s, scene);
  tp_scene_free(scene);
  say_shaken(s);
}
