/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The answer of a tilt test against what it costs: a curve for each setting from coarse to fine,
 * each bracket as a bar, between the onset and the limit of statics. A panel a direction. */

#include "chart/chart.h"
#include "common/host.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

static const tp_chart_colour colours[TP_CONVERGE_SETTINGS] = {
    TP_COLOUR_BLACK, TP_COLOUR_BLUE,   TP_COLOUR_SKY_BLUE, TP_COLOUR_VERMILLION,
    TP_COLOUR_GREEN, TP_COLOUR_ORANGE, TP_COLOUR_PURPLE,   TP_COLOUR_YELLOW};

static const char *const keys[] = {"towards", "setting", NULL};
static const char *const notes[] = {"value", "runs", NULL};

static double middle(const tp_converge_level *level) {
  return 0.5 * (level->bracket_least + level->bracket_most);
}

static void widen(tp_chart_range *range, double least, double most) {
  range->from = fmin(range->from, least);
  range->to = fmax(range->to, most);
}

/* What all levels take and come to, with some room about it. */
static void find_ranges(tp_chart_range *time, tp_chart_range *answer,
                        const tp_tilt_convergence_case *own, bool angle) {
  *time = *answer = (tp_chart_range){DBL_MAX, -DBL_MAX};
  for (size_t k = 0; k < own->level_count; k++) {
    const tp_converge_level *level = own->levels + k;
    if (!level->known) continue;
    const double ms = fmax(1e3 * level->seconds, 1e-6);
    widen(time, pow(10, floor(log10(ms))), pow(10, floor(log10(ms)) + 1));
    widen(answer, level->bracket_least, level->bracket_most);
  }
  if (angle && own->has_onset) widen(answer, own->onset_deg, own->onset_deg);
  const double room = fmax(0.1 * (answer->to - answer->from), 1e-9 * fabs(answer->to));
  answer->from -= room;
  answer->to += room > 0 ? room : 1e-9;
}

/* Where along the axis of time its name begins, clear of the axis on the left. */
#define LABEL_AT 0.02

static void add_statics(tp_chart *chart, double at, tp_chart_range time, const char *name) {
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_DASHED, 0});
  tp_chart_add_corner(chart, time.from, at);
  tp_chart_add_corner(chart, time.to, at);
  tp_chart_add_label(chart, time.from * pow(time.to / time.from, LABEL_AT), at, TP_LABEL_ALONG,
                     name);
}

static void add_curve(tp_chart *chart, const tp_converge_finding *f,
                      const tp_tilt_convergence_case *own) {
  const tp_chart_colour colour = colours[f->setting];
  const char *towards = own->towards == TP_TOWARDS_LEFT ? "left" : "right";
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_LINE, colour, TP_DASH_SOLID, 0});
  for (size_t k = f->first; k < f->first + f->count; k++) {
    const tp_converge_level *level = own->levels + k;
    if (level->known) tp_chart_add_corner(chart, 1e3 * level->seconds, middle(level));
  }
  for (size_t k = f->first; k < f->first + f->count; k++) { /* the brackets */
    const tp_converge_level *level = own->levels + k;
    if (!level->known) continue;
    tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_LINE, colour, TP_DASH_SOLID, 0.4});
    tp_chart_add_corner(chart, 1e3 * level->seconds, level->bracket_least);
    tp_chart_add_corner(chart, 1e3 * level->seconds, level->bracket_most);
  }
  tp_chart_add_series(chart, (tp_chart_style){TP_MARK_POINTS, colour, TP_DASH_SOLID, 0},
                      (const char *const[]){towards, tp_converge_setting_name(f->setting)});
  for (size_t k = f->first; k < f->first + f->count; k++) {
    const tp_converge_level *level = own->levels + k;
    char text[40];
    if (!level->known) continue;
    const double half = 0.5 * (level->bracket_most - level->bracket_least);
    tp_chart_add_point(chart, tp_chart_exactly(1e3 * level->seconds),
                       (tp_bounded){.value = middle(level), .error = half});
    snprintf(text, sizeof text, "%.6g", level->value);
    tp_chart_add_note(chart, 0, text);
    snprintf(text, sizeof text, "%zu", level->runs);
    tp_chart_add_note(chart, 1, text);
  }
}

static void add_case(tp_chart *chart, const tp_tilt_convergence_case *own, bool angle) {
  tp_panel_axis x = {.label = "Time of the test (ms)", .logarithmic = true};
  tp_panel_axis y = {.label = angle ? "Critical angle (°)" : "Least overturning factor"};
  find_ranges(&x.range, &y.range, own, angle);
  tp_chart_add_panel(
      chart, own->towards == TP_TOWARDS_LEFT ? "towards the left" : "towards the right", x, y);
  if (angle && own->has_onset) add_statics(chart, own->onset_deg, x.range, "onset");
  if (angle && own->has_limit && own->limit_deg > own->onset_deg + 1e-9 &&
      own->limit_deg < y.range.to) {
    add_statics(chart, own->limit_deg, x.range, "limit");
  }
  for (size_t k = 0; k < own->setting_count; k++) add_curve(chart, own->settings + k, own);
}

static void add_legend(tp_chart *chart, const tp_tilt_convergence_case *own) {
  for (size_t k = 0; k < own->setting_count; k++) {
    const tp_converge_setting setting = own->settings[k].setting;
    tp_chart_add_legend(chart, tp_converge_setting_name(setting),
                        (tp_chart_style){TP_MARK_LINE, colours[setting], TP_DASH_SOLID, 0});
  }
}

tp_status tp_chart_tilt_convergence(tp_chart **chart, const tp_tilt_convergence *convergence,
                                    tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, convergence);
  const bool angle = convergence->quantity == TP_CONVERGE_ANGLE;
  const tp_tilt_convergence_case *first = NULL;
  for (size_t k = 0; k < convergence->case_count && first == NULL; k++) {
    if (convergence->cases[k].setting_count > 0) first = convergence->cases + k;
  }
  if (first == NULL) {
    return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                   "no test has a bracket that could converge: there is nothing to draw");
  }
  tp_chart *own = tp_chart_new("convergence", keys, "milliseconds",
                               angle ? "critical_angle_deg" : "overturning_factor", notes);
  if (own == NULL) return tp_fail_memory(message, "the chart");
  for (size_t k = 0; k < convergence->source_count; k++) {
    tp_chart_add_source(own, convergence->sources[k]);
  }
  if (convergence->title != NULL) tp_chart_set_title(own, convergence->title);
  own->columns = 2;
  own->panel_width_mm = 80;
  own->panel_height_mm = 70;
  for (size_t k = 0; k < convergence->case_count; k++) {
    if (convergence->cases[k].setting_count > 0) add_case(own, convergence->cases + k, angle);
  }
  if (own->panel_count == 1) own->columns = 1;
  add_legend(own, first);
  return tp_chart_finish(own, chart, message);
}
