/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Phase portraits of a block that moves: its turn against its angular velocity, and the
 * displacement of its centroid along the base against its speed. Points are the test's moments; at
 * an impact two of them stand at one time, with what it took between them. */

#include "chart/tilt_curves.h"
#include "common/host.h"
#include "common/message.h"

#include <math.h>
#include <stdio.h>

enum { MOTIONS = 2 };

static const char *const keys[] = {"towards", "motion", NULL};
static const char *const notes[] = {"time_s", NULL};
static const char *const motion_names[MOTIONS] = {"turning", "along the base"};
static const double degrees = 57.295779513082323;
static const tp_chart_style curve = {TP_MARK_LINE, TP_COLOUR_BLUE, TP_DASH_SOLID, 0};
static const tp_chart_style start_mark = {TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_DOTTED, 0};
static const tp_chart_style end_mark = {TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0};

typedef struct phase {
  double place, speed;
} phase;

static phase phase_of(const tp_tilt_test *test, const tp_tilt_moment *m, int motion) {
  const double unit = test->metres_per_unit;
  return motion == 0 ? (phase){m->turned_deg, m->turning_rad_s * degrees}
                     : (phase){m->moved_x_m / unit, m->speed_x_m_s};
}

static void mark(tp_chart *chart, phase at, tp_chart_style style) {
  tp_chart_add_guide(chart, style);
  tp_chart_add_corner(chart, at.place, at.speed);
}

static void add_curve(tp_chart *chart, const tp_tilt_test *test, const tp_tilt_case *own,
                      int motion) {
  tp_chart_add_series(chart, curve,
                      (const char *const[]){tp_chart_towards(own->towards), motion_names[motion]});
  for (size_t k = 0; k < own->moment_count; k++) {
    const phase at = phase_of(test, own->moments + k, motion);
    char time[40];
    snprintf(time, sizeof time, "%.17g", own->moments[k].time_s);
    tp_chart_add_corner(chart, at.place, at.speed);
    tp_chart_add_note(chart, 0, time);
  }
}

static void add_panel(tp_chart *chart, const tp_tilt_test *test, const tp_tilt_case *own,
                      int motion) {
  char title[64], label[64];
  tp_chart_range x = tp_chart_range_empty(), y = tp_chart_range_empty();
  for (size_t k = 0; k < own->moment_count; k++) {
    const phase at = phase_of(test, own->moments + k, motion);
    tp_chart_range_take(&x, at.place);
    tp_chart_range_take(&y, at.speed);
  }
  x = tp_chart_range_drawn(x);
  y = tp_chart_range_drawn(y);
  snprintf(title, sizeof title, "Tilted towards the %s", tp_chart_towards(own->towards));
  snprintf(label, sizeof label, "Centroid moved along the base (%s)", test->length_unit);
  tp_chart_add_panel(
      chart, test->case_count > 1 ? title : NULL,
      (tp_panel_axis){.label = motion == 0 ? "Turned counter-clockwise (°)" : label, .range = x},
      (tp_panel_axis){.label = motion == 0 ? "Angular velocity (°/s)" : "Speed (m/s)", .range = y});
  tp_chart_add_level(chart, x, y, 0);
  add_curve(chart, test, own, motion);
  mark(chart, phase_of(test, own->moments, motion), start_mark);
  mark(chart, phase_of(test, own->moments + own->moment_count - 1, motion), end_mark);
}

static bool moves(const tp_tilt_case *own) {
  for (size_t k = 0; k < own->moment_count; k++) {
    const tp_tilt_moment *m = own->moments + k;
    if (m->speed_x_m_s != 0 || m->speed_y_m_s != 0 || m->turning_rad_s != 0) return true;
  }
  return false;
}

tp_status tp_chart_tilt_phase(tp_chart **chart, const tp_tilt_test *test, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, test);
  bool any = false;
  for (size_t c = 0; c < test->case_count; c++) any = any || moves(test->cases + c);
  if (!any) {
    return tp_fail(message, TP_NO_ANSWER, (tp_place){0}, "%s",
                   test->settings.engine == TP_TILT_PATH
                       ? "a path simulates no motion, and has no phase portrait: take 'engine: "
                         "dynamics'"
                       : "nothing moves in the test: there is no phase portrait");
  }
  tp_chart *own = tp_chart_new("tilt_phase", keys, "place", "speed", notes);
  if (own == NULL) return tp_fail_memory(message, "the chart");
  if (test->title != NULL) tp_chart_set_title(own, test->title);
  own->columns = MOTIONS;
  own->panel_width_mm = 66;
  own->panel_height_mm = 50;
  own->rows_are_named = true;
  for (size_t c = 0; c < test->case_count; c++) {
    if (!moves(test->cases + c)) continue;
    for (int k = 0; k < MOTIONS; k++) add_panel(own, test, test->cases + c, k);
  }
  tp_chart_add_legend(own, "start", start_mark);
  tp_chart_add_legend(own, "end", end_mark);
  return tp_chart_finish(own, chart, message);
}
