/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An overturning spectrum as a chart: PGA against the frequency, and against PGV. A bracket stands
 * as its middle, with half its width as the error: that much was run, and is not proven. */

#include "chart/tilt_curves.h"
#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "scene/check_tilt_test.h"
#include "tilt/overturning_spectrum.h"

#include <math.h>
#include <stdio.h>

TP_OPTIONS_END(tp_overturning_options, context);

enum { PANELS = 2 };

static const double standard_gravity = 9.80665;
static const char *const keys[] = {"towards", "panel_of", "edge", NULL};
static const char *const notes[] = {"frequency", "pgv_m_s", "runs_decided", NULL};
static const char *const panel_names[PANELS] = {"frequency", "pgv"};
static const tp_chart_style least_line = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_SOLID, 0};
static const tp_chart_style island_line = {TP_MARK_LINE, TP_COLOUR_GREEN, TP_DASH_SOLID, 1.6};
static const tp_chart_style from_mark = {TP_MARK_POINTS, TP_COLOUR_GREEN, TP_DASH_SOLID, 0};
static const tp_chart_style to_mark = {TP_MARK_POINTS, TP_COLOUR_GREEN, TP_DASH_DOTTED, 0};
static const tp_chart_style static_line = {TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_DASHED, 0.8};

void tp_overturning_options_init(tp_overturning_options *options, size_t size) {
  const tp_overturning_options defaults = {.size = sizeof defaults, .count = 25, .tolerance = 1e-3};
  tp_options_fill(options, size, &defaults);
}

/* ---- points ------------------------------------------------------------------------------------
 */

static double middle(tp_pga_bracket b) {
  return (b.low_m_s2 + b.high_m_s2) / 2;
}

static double abscissa(const tp_overturning_point *p, tp_pga_bracket at, int panel) {
  return panel == 0 ? p->frequency : middle(at) * p->velocity_s;
}

static void add_point(tp_chart *chart, const tp_overturning_point *p, tp_pga_bracket at,
                      int panel) {
  const double half = (at.high_m_s2 - at.low_m_s2) / 2;
  const tp_bounded y = {.value = middle(at) / standard_gravity, .error = half / standard_gravity},
                   x = {.value = abscissa(p, at, panel),
                        .error = panel == 0 ? 0 : half * p->velocity_s};
  char text[40];
  tp_chart_add_point(chart, x, y);
  snprintf(text, sizeof text, "%.15g", p->frequency);
  tp_chart_add_note(chart, 0, text);
  snprintf(text, sizeof text, "%.15g", middle(at) * p->velocity_s);
  tp_chart_add_note(chart, 1, text);
  tp_chart_add_note(chart, 2, p->converged ? "all" : "not all");
}

static void begin(tp_chart *chart, const tp_overturning_case *own, int panel, const char *edge,
                  tp_chart_style style) {
  tp_chart_add_series(
      chart, style,
      (const char *const[]){tp_chart_towards(own->towards), panel_names[panel], edge});
}

static void add_least(tp_chart *chart, const tp_overturning_case *own, int panel) {
  begin(chart, own, panel, "least found that overturns", least_line);
  for (size_t k = 0; k < own->count; k++) {
    if (own->points[k].overturns) add_point(chart, own->points + k, own->points[k].least, panel);
  }
}

static void add_islands(tp_chart *chart, const tp_overturning_case *own, int panel, bool *any) {
  for (size_t k = 0; k < own->count; k++) {
    const tp_overturning_point *p = own->points + k;
    for (size_t i = 0; i < p->island_count; i++) {
      const tp_spared_island *island = p->islands + i;
      tp_chart_add_guide(chart, island_line);
      tp_chart_add_corner(chart, abscissa(p, island->from, panel),
                          middle(island->from) / standard_gravity);
      tp_chart_add_corner(chart, abscissa(p, island->to, panel),
                          middle(island->to) / standard_gravity);
      begin(chart, own, panel, "stands again from", from_mark);
      add_point(chart, p, island->from, panel);
      begin(chart, own, panel, island->open ? "stands up to the strongest tried" : "stands up to",
            to_mark);
      add_point(chart, p, island->to, panel);
      *any = true;
    }
  }
}

/* ---- the panels --------------------------------------------------------------------------------
 */

static void take(tp_chart_range *range, double value) {
  tp_chart_range_take(range, value);
}

static void take_ranges(tp_chart_range *x, tp_chart_range *y, const tp_overturning_case *own,
                        int panel) {
  for (size_t k = 0; k < own->count; k++) {
    const tp_overturning_point *p = own->points + k;
    if (!p->overturns) continue;
    take(x, abscissa(p, p->least, panel));
    take(y, middle(p->least) / standard_gravity);
    for (size_t i = 0; i < p->island_count; i++) {
      take(x, abscissa(p, p->islands[i].to, panel));
      take(y, middle(p->islands[i].to) / standard_gravity);
    }
  }
  if (own->has_static) take(y, own->static_m_s2 / standard_gravity);
}

/* Of some decades labels within them, of many none. */
static double tick_of(tp_chart_range range) {
  return range.to < 100 * range.from ? 1 : 0;
}

/* A tenth more on either side. */
static tp_chart_range widened(tp_chart_range range) {
  return (tp_chart_range){range.from / 1.1, range.to * 1.1};
}

static void add_static(tp_chart *chart, const tp_overturning_case *own, tp_chart_range x) {
  if (!own->has_static) return;
  tp_chart_add_guide(chart, static_line);
  tp_chart_add_corner(chart, x.from, own->static_m_s2 / standard_gravity);
  tp_chart_add_corner(chart, x.to, own->static_m_s2 / standard_gravity);
}

static void add_panel(tp_chart *chart, const tp_overturning_spectrum *spectrum,
                      const tp_overturning_case *own, int panel, bool *any) {
  char title[64];
  tp_chart_range x = tp_chart_range_empty(), y = tp_chart_range_empty();
  take_ranges(&x, &y, own, panel);
  if (!(x.from <= x.to)) return;
  x = widened(x);
  y = widened(y);
  const char *of_frequency =
      spectrum->of_record ? "Times as fast as recorded" : "Frequency of the pulse (Hz)";
  snprintf(title, sizeof title, "Tilted towards the %s", tp_chart_towards(own->towards));
  tp_chart_add_panel(
      chart, spectrum->case_count > 1 ? title : NULL,
      (tp_panel_axis){.label = panel == 0 ? of_frequency : "PGV (m/s)",
                      .range = x,
                      .tick = tick_of(x),
                      .logarithmic = true},
      (tp_panel_axis){.label = "PGA (g)", .range = y, .tick = tick_of(y), .logarithmic = true});
  add_static(chart, own, x);
  add_islands(chart, own, panel, any);
  add_least(chart, own, panel);
}

static bool overturns(const tp_overturning_case *own) {
  for (size_t k = 0; k < own->count; k++) {
    if (own->points[k].overturns) return true;
  }
  return false;
}

static tp_status draw(tp_chart **chart, const tp_overturning_spectrum *spectrum, const char *title,
                      tp_message *message) {
  bool any = false, has_static = false;
  tp_chart *own = tp_chart_new("overturning", keys, "x", "pga_g", notes);
  if (own == NULL) return tp_fail_memory(message, "the chart");
  if (title != NULL) tp_chart_set_title(own, title);
  own->columns = PANELS;
  own->panel_width_mm = 66;
  own->panel_height_mm = 60;
  own->rows_are_named = true;
  for (size_t k = 0; k < spectrum->case_count; k++) {
    const tp_overturning_case *c = spectrum->cases + k;
    if (!overturns(c)) continue;
    has_static = has_static || c->has_static;
    for (int panel = 0; panel < PANELS; panel++) add_panel(own, spectrum, c, panel, &any);
  }
  tp_chart_add_legend(own, "least found that overturns it", least_line);
  if (any) tp_chart_add_legend(own, "stands again", island_line);
  if (has_static) tp_chart_add_legend(own, "static limit", static_line);
  return tp_chart_finish(own, chart, message);
}

/* ---- the call ----------------------------------------------------------------------------------
 */

static tp_status refuse(tp_message *message, tp_place place, const char *what) {
  return tp_refuse(message, TP_FAULT_RANGE, place, "%s", what);
}

static tp_status check(const tp_scene *scene, const tp_overturning_options *o,
                       tp_message *message) {
  const bool open = o->from == 0 && o->to == 0;
  if (!open && !(o->from > 0 && o->from < o->to && isfinite(o->to))) {
    return refuse(message, (tp_place){0},
                  "frequencies of an overturning spectrum go from one above 0 to a larger one");
  }
  if (o->count < 2 || o->count > TP_FREQUENCIES_MAX) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "an overturning spectrum has 2 to %d frequencies", (int)TP_FREQUENCIES_MAX);
  }
  if (!(o->tolerance >= 1e-6 && o->tolerance <= 0.1)) {
    return refuse(message, (tp_place){0},
                  "the tolerance of an overturning spectrum lies between 1e-6 and 0.1");
  }
  if (!tp_scene_is_shaken(scene) || scene->shaking[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_NONE) {
    return refuse(message, (tp_place){scene->path, 0, 0},
                  "an overturning spectrum needs a base that shakes: add 'shaking: {horizontal: "
                  "{half_sine: {peak_g: 1, frequency_hz: 1}}}'");
  }
  if (!scene->friction_angle_deg.given) {
    return refuse(message, (tp_place){scene->path, 0, 0},
                  "'friction_angle_deg' is missing: without it no contact can be simulated");
  }
  return TP_OK;
}

static tp_status tell_none(const tp_overturning_spectrum *spectrum, tp_message *message) {
  size_t count = 0;
  for (size_t k = 0; k < spectrum->case_count; k++) count += spectrum->cases[k].count;
  if (count == 0) {
    return tp_fail(message, TP_UNDECIDED, (tp_place){0},
                   "the overturning spectrum was interrupted before anything was known");
  }
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                 "no shaking of up to 64 g overturns the block at any of the frequencies, or runs "
                 "were not decided");
}

tp_status tp_chart_overturning(tp_chart **chart, const tp_scene *scene,
                               const tp_overturning_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_overturning_options own = tp_overturning_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  tp_overturning_spectrum spectrum;
  tp_status status = check(scene, &own, message);
  if (status == TP_OK) status = tp_overturning_spectrum_init(&spectrum, scene, &own, message);
  if (status != TP_OK) return status;
  bool any = false;
  for (size_t k = 0; k < spectrum.case_count; k++) any = any || overturns(spectrum.cases + k);
  status = any ? draw(chart, &spectrum, scene->title, message) : tell_none(&spectrum, message);
  tp_overturning_spectrum_clear(&spectrum);
  return status;
}
