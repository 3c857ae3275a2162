/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls on profiles say: of a file, of points, of a base, and the names of their options.
 */

#include "sayings.h"

#define EXAMPLE(name) TP_EXAMPLES "/" name

/* By its place: an argument is read before a call beside it fills it in. */
static void say_measured(sayings *s, tp_status status, tp_profile *const *made,
                         const tp_message *message) {
  const tp_profile *profile = *made;
  tp_chart *chart = NULL;
  tp_message why = {.text = ""};
  note_status(s, status, message);
  if (profile == NULL) return;
  if (tp_report_profile(next_saying(s), profile) != TP_OK) s->count--;
  if (tp_report_profile_json(next_saying(s), profile, true) != TP_OK) s->count--;
  if (tp_report_profile_csv(next_saying(s), profile) != TP_OK) s->count--;
  note_status(s, tp_chart_profile(&chart, profile, &why), &why);
  if (chart != NULL && tp_report_chart_csv(next_saying(s), chart) != TP_OK) s->count--;
  tp_chart_free(chart);
  tp_profile_free(*made);
}

static void say_option_names(sayings *s) {
  static const char *const words[] = {"linear", "spline", "line", "ends", "none", "hann", "x"};
  for (size_t k = 0; k < sizeof words / sizeof words[0]; k++) {
    tp_profile_resampling resampling = TP_RESAMPLE_LINEAR;
    tp_profile_detrend detrend = TP_DETREND_NONE;
    tp_profile_window window = TP_WINDOW_HANN;
    tp_message name = {.text = ""};
    note_number(s, tp_profile_resampling_read(&resampling, words[k]));
    note_number(s, tp_profile_detrend_read(&detrend, words[k]));
    note_number(s, tp_profile_window_read(&window, words[k]));
    tp_plain_text(name.text, sizeof name.text, tp_profile_resampling_name(resampling));
    note_status(s, TP_OK, &name);
    tp_plain_text(name.text, sizeof name.text, tp_profile_detrend_name(detrend));
    note_status(s, TP_OK, &name);
    tp_plain_text(name.text, sizeof name.text, tp_profile_window_name(window));
    note_status(s, TP_OK, &name);
    tp_plain_text(name.text, sizeof name.text, tp_jrc_state_name((tp_jrc_state)k));
    note_status(s, TP_OK, &name);
  }
}

void say_profiles(sayings *s) {
  static const double xy[] = {0, 0.1, 1.5, 1.25, 2.75, 0.3, 4.1, 1, 5, 0};
  tp_message message = {.text = ""};
  tp_profile *made[3] = {NULL};
  tp_scene *scene = NULL;
  tp_profile_options options = tp_profile_options_default();
  say_measured(s, tp_profile_of_points(made, tp_coordinates_of(xy, 5), "cm", &options, &message),
               made, &message);
  options.step = 0.3;
  options.detrend = TP_DETREND_LINE;
  options.resampling = TP_RESAMPLE_SPLINE;
  say_measured(s,
               tp_profile_of_file(made + 1, EXAMPLE("joint_profile.csv"), "mm", &options, &message),
               made + 1, &message);
  options = tp_profile_options_default();
  options.jcs_mpa = 120.5;
  note_status(s, tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message), &message);
  if (scene != NULL) {
    say_measured(s, tp_profile_of_scene(made + 2, scene, &options, &message), made + 2, &message);
  }
  tp_scene_free(scene);
  say_option_names(s);
}
