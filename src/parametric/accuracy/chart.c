/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What accuracy costs, as charts: a scene's time against certain digits, with a hair line from the
 * digits that are proven to those that are right; a sweep's time and digits against size. */

#include "accuracy/accuracy.h"
#include "chart/labels.h"
#include "common/host.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

static const tp_chart_colour method_colours[TP_ACCURACY_METHODS] = {
    TP_COLOUR_BLUE,       TP_COLOUR_SKY_BLUE, TP_COLOUR_ORANGE,
    TP_COLOUR_VERMILLION, TP_COLOUR_GREEN,    TP_COLOUR_PURPLE};
static const tp_chart_colour level_colours[TP_LEVELS] = {TP_COLOUR_ORANGE, TP_COLOUR_VERMILLION,
                                                         TP_COLOUR_GREEN, TP_COLOUR_BLUE};
static const tp_chart_dash method_dashes[TP_ACCURACY_METHODS] = {TP_DASH_SOLID,    TP_DASH_DASHED,
                                                                 TP_DASH_DASH_DOT, TP_DASH_DASH_DOT,
                                                                 TP_DASH_DOTTED,   TP_DASH_LONG};

static const char *const keys[] = {"method", "level", "bits", NULL};
static const char *const notes[] = {"true_digits", NULL};

/* Digits of the angle's own size; of a degree where it is 0. Infinite where nothing is left. */
static double digits_of(double log10_error, const tp_accuracy *a, const tp_accuracy_run *run) {
  for (size_t k = 0; k < a->value_count; k++) {
    const tp_accuracy_value *value = a->values + k;
    if (value->method != run->method || value->vertices != run->vertices) continue;
    const double size = fabs(value->angle_deg.value);
    return (size > 0 ? log10(size) : 0) - log10_error;
  }
  return -log10_error;
}

/* Proven; of what has no bound, those that are right. */
static double digits(const tp_accuracy *a, const tp_accuracy_run *run) {
  return digits_of(run->has_bound ? run->bound_log10 : run->true_error_log10, a, run);
}

static void begin_series(tp_chart *chart, const tp_accuracy_run *run, tp_chart_style style,
                         bool with_bits) {
  char bits[24];
  snprintf(bits, sizeof bits, "%ld", run->bits);
  tp_chart_add_series(chart, style,
                      (const char *const[]){tp_accuracy_method_name(run->method),
                                            tp_level_name(run->level), with_bits ? bits : ""});
}

static void add_point(tp_chart *chart, const tp_accuracy *a, const tp_accuracy_run *run, double x,
                      double y) {
  char text[32];
  const double right = digits_of(run->true_error_log10, a, run);
  tp_chart_add_point(chart, tp_chart_exactly(x), tp_chart_exactly(y));
  snprintf(text, sizeof text, isfinite(right) ? "%.1f" : "all", right);
  tp_chart_add_note(chart, 0, text);
}

/* The runs of one method and level in a row: a curve where they are several. */
static size_t count_of_row(const tp_accuracy *a, size_t from) {
  size_t count = 1;
  const tp_accuracy_run *first = a->runs + from;
  while (from + count < a->run_count && a->runs[from + count].method == first->method &&
         a->runs[from + count].level == first->level) {
    count++;
  }
  return count;
}

/* A grey line from the digits that are proven to those that are right. */
static void add_margin(tp_chart *chart, const tp_accuracy *a, const tp_accuracy_run *run,
                       double most) {
  const double proven = digits(a, run), right = digits_of(run->true_error_log10, a, run);
  if (!run->has_bound || !isfinite(proven)) return;
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_SOLID, 0.4});
  tp_chart_add_corner(chart, proven, 1e6 * run->seconds);
  tp_chart_add_corner(chart, fmin(right, most), 1e6 * run->seconds);
}

static void add_row(tp_chart *chart, const tp_accuracy *a, size_t from, size_t count) {
  const tp_accuracy_run *first = a->runs + from;
  const tp_chart_style points = {TP_MARK_POINTS, method_colours[first->method], TP_DASH_SOLID, 0};
  const tp_chart_style line = {TP_MARK_LINE, method_colours[first->method],
                               first->level == TP_LEVEL_EXACT ? TP_DASH_DASHED : TP_DASH_SOLID, 0};
  if (count > 1) {
    tp_chart_add_guide(chart, line);
    for (size_t k = from; k < from + count; k++) {
      const double x = digits(a, a->runs + k);
      if (isfinite(x)) tp_chart_add_corner(chart, x, 1e6 * a->runs[k].seconds);
    }
  }
  begin_series(chart, first, points, false);
  for (size_t k = from; k < from + count; k++) {
    const double x = digits(a, a->runs + k);
    if (isfinite(x)) add_point(chart, a, a->runs + k, x, 1e6 * a->runs[k].seconds);
  }
}

/* The prices that the legend does not tell. */
static void add_names(tp_chart *chart, const tp_accuracy *a) {
  for (size_t k = 0; k < a->run_count; k++) {
    const tp_accuracy_run *run = a->runs + k;
    const bool named = run->method == TP_ACCURACY_BOUNDARY && run->level < TP_LEVEL_BALL;
    const double x = digits(a, run);
    if (!isfinite(x) || (run->has_bound && !named)) continue;
    const char *text = run->has_bound ? tp_level_name(run->level) : "limit in doubles, not proven";
    const double time = 1e6 * run->seconds;
    tp_chart_add_label(chart, x, time, tp_chart_free_side(chart, x, time, text), text);
  }
}

/* A whole decade on either side. */
static void widen(tp_chart_range *range, double value) {
  if (!isfinite(value) || value <= 0) return;
  const double below = pow(10, floor(log10(value))), above = pow(10, ceil(log10(value)));
  range->from = fmin(range->from, below);
  range->to = fmax(range->to, above);
}

static const tp_accuracy_value *value_of(const tp_accuracy *a, tp_accuracy_method method) {
  for (size_t k = 0; k < a->value_count; k++) {
    if (a->values[k].method == method) return a->values + k;
  }
  return NULL;
}

/* Where the two models of a rounded corner part: digits beyond are digits of a model. */
static void add_models(tp_chart *chart, const tp_accuracy *a, const tp_panel_axis *x,
                       const tp_panel_axis *y) {
  const tp_accuracy_value *paper = value_of(a, TP_ACCURACY_ROUNDED_PAPER);
  const tp_accuracy_value *exact = value_of(a, TP_ACCURACY_ROUNDED_EXACT);
  if (paper == NULL || exact == NULL) return;
  const double apart = fabs(paper->angle_deg.value - exact->angle_deg.value);
  const double at = log10(fabs(exact->angle_deg.value) / apart);
  if (!(at > x->range.from && at < x->range.to)) return;
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_DASHED, 0});
  tp_chart_add_corner(chart, at, y->range.from);
  tp_chart_add_corner(chart, at, y->range.to);
  tp_chart_add_label(chart, at, y->range.to * 0.6, TP_LABEL_RIGHT,
                     "here the two models of the corner part");
}

static void add_scene_legend(tp_chart *chart, const tp_accuracy *a) {
  for (size_t k = 0; k < a->value_count; k++) {
    const tp_accuracy_method method = a->values[k].method;
    tp_chart_add_legend(chart, tp_accuracy_method_name(method),
                        (tp_chart_style){TP_MARK_LINE, method_colours[method], TP_DASH_SOLID, 0});
  }
  tp_chart_add_legend(chart, "balls of 53 to 4096 bits",
                      (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0});
  tp_chart_add_legend(chart, "exact sums or program",
                      (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DASHED, 0});
  tp_chart_add_legend(chart, "from proven to right digits",
                      (tp_chart_style){TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_SOLID, 0.4});
}

static void draw_scene(tp_chart *chart, const tp_accuracy *a) {
  const tp_panel_axis x = {.label = "Certain digits",
                           .range = {3, 2000}, /* 4096 bits are 1233 digits */
                           .logarithmic = true};
  tp_panel_axis y = {
      .label = "Time of one evaluation (µs)", .range = {DBL_MAX, 0}, .logarithmic = true};
  for (size_t k = 0; k < a->run_count; k++) {
    widen(&y.range, 1e6 * a->runs[k].seconds);
  }
  chart->panel_width_mm = 110;
  chart->panel_height_mm = 72;
  if (a->title != NULL) tp_chart_set_title(chart, a->title);
  tp_chart_add_panel(chart, NULL, x, y);
  for (size_t k = 0; k < a->run_count; k++) add_margin(chart, a, a->runs + k, x.range.to);
  for (size_t k = 0; k < a->run_count; k += count_of_row(a, k)) {
    add_row(chart, a, k, count_of_row(a, k));
  }
  add_names(chart, a);
  add_models(chart, a, &x, &y);
  add_scene_legend(chart, a);
}

static bool is_first(const tp_accuracy *a, size_t at) {
  for (size_t k = 0; k < at; k++) {
    if (a->runs[k].method == a->runs[at].method && a->runs[k].level == a->runs[at].level)
      return false;
  }
  return true;
}

static tp_chart_style sweep_style(const tp_accuracy_run *run) {
  return (tp_chart_style){TP_MARK_LINE, level_colours[run->level], method_dashes[run->method], 0};
}

/* Over size: nanoseconds a vertex, or digits. */
static void add_sweep_curves(tp_chart *chart, const tp_accuracy *a, bool times) {
  for (size_t k = 0; k < a->run_count; k++) {
    if (!is_first(a, k)) continue;
    begin_series(chart, a->runs + k, sweep_style(a->runs + k), true);
    for (size_t j = k; j < a->run_count; j++) {
      const tp_accuracy_run *run = a->runs + j;
      if (run->method != a->runs[k].method || run->level != a->runs[k].level) continue;
      const double y = times ? 1e9 * run->seconds / (double)run->vertices : digits(a, run);
      if (isfinite(y)) add_point(chart, a, run, (double)run->vertices, y);
    }
  }
}

static void draw_sweep(tp_chart *chart, const tp_accuracy *a) {
  tp_panel_axis x = {.label = "Vertices", .range = {DBL_MAX, 0}, .logarithmic = true};
  tp_panel_axis time = {.label = "Time (ns a vertex)", .range = {DBL_MAX, 0}, .logarithmic = true};
  for (size_t k = 0; k < a->run_count; k++) {
    widen(&x.range, (double)a->runs[k].vertices);
    widen(&time.range, 1e9 * a->runs[k].seconds / (double)a->runs[k].vertices);
  }
  const tp_panel_axis proven = {.label = "Certain digits", .range = {0, 100}, .tick = 20};
  chart->columns = 2;
  chart->panel_width_mm = 68;
  chart->panel_height_mm = 62;
  tp_chart_add_panel(chart, NULL, x, time);
  add_sweep_curves(chart, a, true);
  tp_chart_add_panel(chart, NULL, x, proven);
  add_sweep_curves(chart, a, false);
  for (size_t k = 0; k < a->run_count; k++) {
    char text[80];
    if (!is_first(a, k)) continue;
    snprintf(text, sizeof text, "%s, %s%s", tp_accuracy_method_name(a->runs[k].method),
             tp_level_name(a->runs[k].level), a->runs[k].has_bound ? "" : " (not proven)");
    tp_chart_add_legend(chart, text, sweep_style(a->runs + k));
  }
}

tp_status tp_chart_accuracy(tp_chart **chart, const tp_accuracy *accuracy, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, accuracy);
  tp_chart *own = tp_chart_new(accuracy->sweep ? "accuracy by size" : "accuracy", keys,
                               accuracy->sweep ? "vertices" : "certain_digits",
                               accuracy->sweep ? "ns_per_vertex_or_digits" : "microseconds", notes);
  if (own == NULL) {
    return tp_fail_memory(message, "the chart");
  }
  for (size_t k = 0; k < accuracy->source_count; k++) {
    tp_chart_add_source(own, accuracy->sources[k]);
  }
  if (accuracy->sweep) {
    draw_sweep(own, accuracy);
  } else {
    draw_scene(own, accuracy);
  }
  return tp_chart_finish(own, chart, message);
}
