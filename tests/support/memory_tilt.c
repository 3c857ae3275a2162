/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_tilt.h"

#include "memory_expect.h"

#define HEAD                                                                                       \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: 40\ntilt: {towards: left}\n"                     \
  "block: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 25}\n"

static void report(const tp_tilt_test *test) {
  typedef tp_status reporter(char **text, const tp_tilt_test *test);
  static reporter *const reporters[] = {tp_report_tilt, tp_report_tilt_json, tp_report_tilt_csv,
                                        tp_report_tilt_frames, tp_report_tilt_animation};
  for (size_t k = 0; k < sizeof reporters / sizeof reporters[0]; k++) {
    char *text = NULL;
    const tp_status status = reporters[k](&text, test);
    expect_report(status, text);
  }
}

static void chart(const tp_tilt_test *test) {
  typedef tp_status maker(tp_chart * *chart, const tp_tilt_test *test, tp_message *message);
  static maker *const makers[] = {tp_chart_tilt_reactions, tp_chart_tilt_phase};
  for (size_t k = 0; k < sizeof makers / sizeof makers[0]; k++) {
    tp_chart *chart = NULL;
    tp_message message = {.text = ""};
    if (k == 1 && test->settings.engine == TP_TILT_PATH) continue;
    (void)DONE(makers[k](&chart, test, &message), chart);
    tp_chart_free(chart);
  }
}

static void vary(const char *text) {
  tp_scene *scene = NULL;
  tp_tilt_convergence *convergence = NULL;
  tp_chart *chart = NULL;
  tp_message message = {.text = ""};
  const tp_tilt_options options = tp_tilt_options_default();
  if (DONE(tp_scene_read_text(&scene, text, "tilt", &message), scene) &&
      DONE(tp_tilt_converge(&convergence, scene, &options, &message), convergence)) {
    char *report = NULL;
    tp_status status = tp_report_tilt_convergence(&report, convergence);
    expect_report(status, report);
    report = NULL;
    status = tp_report_tilt_convergence_json(&report, convergence);
    expect_report(status, report);
    (void)DONE(tp_chart_tilt_convergence(&chart, convergence, &message), chart);
  }
  tp_chart_free(chart);
  tp_tilt_convergence_free(convergence);
  tp_scene_free(scene);
}

void vary_tilt_test(void) {
  vary(HEAD "tilt_test: {engine: path}\n");
}

static void simulate(const char *text, bool overturning) {
  tp_scene *scene = NULL;
  tp_tilt_test *test = NULL;
  tp_message message = {.text = ""};
  tp_tilt_options options = tp_tilt_options_default();
  options.moments = 10;
  options.overturning = overturning;
  options.overturning_from = overturning ? 0.5 : 0;
  options.overturning_to = overturning ? 3 : 0;
  options.overturning_count = overturning ? 4 : 0;
  if (DONE(tp_scene_read_text(&scene, text, "tilt", &message), scene) &&
      DONE(tp_tilt_test_run(&test, scene, &options, &message), test)) {
    report(test);
    chart(test);
  }
  tp_tilt_test_free(test);
  tp_scene_free(scene);
}

void simulate_tilt_test(void) {
  simulate(HEAD "tilt_test: {engine: path}\n", false);
  simulate(HEAD "tilt_test: {engine: dynamics, protocol: steps, duration_s: 0.2}\n", false);
  simulate(HEAD "tilt_test: {duration_s: 0.1}\n"
                "shaking: {horizontal: {half_sine: {peak_g: 0.5, frequency_hz: 2}}}\n",
           true);
}

void chart_overturning(void) {
  tp_scene *scene = NULL;
  tp_chart *chart = NULL;
  tp_message message = {.text = ""};
  tp_overturning_options options = tp_overturning_options_default();
  options.count = 2;
  options.tolerance = 0.1;
  if (DONE(tp_scene_read_text(
               &scene,
               HEAD "tilt_test: {duration_s: 3}\n"
                    "shaking: {horizontal: {half_sine: {peak_g: 0.5, frequency_hz: 2}}}\n",
               "tilt", &message),
           scene)) {
    (void)DONE(tp_chart_overturning(&chart, scene, &options, &message), chart);
  }
  tp_chart_free(chart);
  tp_scene_free(scene);
}
