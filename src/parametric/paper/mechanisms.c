/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mechanism maps, tilt against inverse slenderness, of a planar and of a rough base (Fig. 18 of
 * Alejano et al.), with the four blocks of Table 7. Borders: it slides beyond phi, or phi + i; it
 * topples beyond the critical angle of the exact block (N = 2; an even N makes no difference). */

#include "chart/mechanism_style.h"
#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "paper/mechanisms_rest.h"
#include "paper/table_7.h"
#include "paper/teeth.h"

#include <math.h>
#include <stdio.h>

enum { POINTS = 121 };

TP_OPTIONS_END(tp_chart_mechanisms_options, amplitude);

void tp_chart_mechanisms_options_init(tp_chart_mechanisms_options *options, size_t size) {
  const tp_chart_mechanisms_options defaults = {
      .size = sizeof defaults, .friction_deg = 30, .roughness_angle_deg = 10, .amplitude = 0.01};
  tp_options_fill(options, size, &defaults);
}

typedef struct drawing {
  tp_chart *chart;
  const tp_chart_mechanisms_options *options;
  tp_message *message;
  const char *panel;
  double x_most, y_most;
} drawing;

static const tp_chart_style line_peak = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_DASHED, 0};
static const tp_chart_style line_valley = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_DOTTED, 0};
static const tp_chart_style dots = {TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0};

static tp_status check(const tp_chart_mechanisms_options *o, tp_message *message) {
  if (!(o->friction_deg > 0 && o->roughness_angle_deg >= 0 &&
        o->friction_deg + o->roughness_angle_deg <= 80)) {
    return tp_refuse(
        message, TP_FAULT_RANGE, (tp_place){0},
        "friction of %g° and a roughness angle of %g°: the friction must be above 0, the "
        "roughness angle not below, and their sum at most 80°",
        o->friction_deg, o->roughness_angle_deg);
  }
  if (!(o->amplitude >= 0 && o->amplitude <= 0.5)) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "a relative amplitude of %g: it must lie between 0 and 0.5", o->amplitude);
  }
  return TP_OK;
}

static void begin_series(const drawing *d, tp_chart_style style, const char *series) {
  tp_chart_add_series(d->chart, style, (const char *const[]){d->panel, series, NULL});
}

static double abscissa(const drawing *d, int k) {
  /* from just above 0: a block has a width */
  return d->x_most * (k > 0 ? k : 1e-3) / (POINTS - 1);
}

static tp_status add_toppling(const drawing *d, tp_toe_kind toe, tp_chart_style style) {
  char name[40];
  tp_status status = TP_OK;
  snprintf(name, sizeof name, toe == TP_TOE_PLANAR ? "topples" : "topples about the %s",
           tp_toe_names[toe]);
  begin_series(d, style, name);
  for (int k = 0; k < POINTS && status == TP_OK; k++) {
    tp_bounded angle = {0};
    const tp_toothed block = {abscissa(d, k), d->options->amplitude, 2};
    status = tp_toothed_critical_angle(&angle, &block, toe, d->message);
    if (status == TP_OK) {
      tp_chart_add_point(d->chart, tp_chart_exactly(block.inverse_slenderness), angle);
    }
  }
  return status;
}

static void add_sliding(const drawing *d, double angle) {
  begin_series(d, tp_line_slides, "slides");
  tp_chart_add_corner(d->chart, 0, angle);
  tp_chart_add_corner(d->chart, d->x_most, angle);
}

/* Fill between two borders of one end of the map to the other. */
typedef enum edge { EDGE_SLIDES, EDGE_TOPPLES, EDGE_HIGHER, EDGE_TOP } edge;

static double height(const drawing *d, edge which, double sliding, double x) {
  const double toppling = fmin(atan(x) * tp_degrees_of_radian, d->y_most);
  switch (which) {
  case EDGE_SLIDES:
    return sliding;
  case EDGE_TOPPLES:
    return toppling;
  case EDGE_HIGHER:
    return fmax(sliding, toppling);
  case EDGE_TOP:
    break;
  }
  return d->y_most;
}

static void add_region(const drawing *d, tp_chart_style style, edge low, edge high, double sliding,
                       double from, double to) {
  tp_chart_add_guide(d->chart, style);
  for (int k = 0; k < POINTS; k++) {
    const double x = from + (to - from) * k / (POINTS - 1);
    tp_chart_add_corner(d->chart, x, height(d, low, sliding, x));
  }
  for (int k = POINTS - 1; k >= 0; k--) {
    const double x = from + (to - from) * k / (POINTS - 1);
    tp_chart_add_corner(d->chart, x, height(d, high, sliding, x));
  }
}

/* The regions by the mean border of toppling, that of the planar base. */
static void add_regions(const drawing *d, double sliding, bool rough) {
  const double meet = tan(sliding / tp_degrees_of_radian), width = d->x_most, top = d->y_most;
  add_region(d, tp_region_topples, EDGE_TOPPLES, EDGE_SLIDES, sliding, 0, meet);
  add_region(d, tp_region_slides, EDGE_SLIDES, EDGE_TOPPLES, sliding, meet, width);
  add_region(d, tp_region_both, EDGE_HIGHER, EDGE_TOP, sliding, 0, width);
  tp_chart_add_label(d->chart, 0.62 * width, 0.3 * sliding, TP_LABEL_CENTRE, "stable");
  tp_chart_add_label(d->chart, (rough ? 0.2 : 0.33) * meet, 0.72 * sliding, TP_LABEL_CENTRE,
                     "topples");
  tp_chart_add_label(d->chart, 0.7 * width, 0.92 * top, TP_LABEL_CENTRE, "slides and topples");
  tp_chart_add_label(d->chart, 0.87 * width,
                     sliding + 0.35 * (atan(width) * tp_degrees_of_radian - sliding),
                     TP_LABEL_CENTRE, "slides");
}

static void add_block(const drawing *d, const tp_table_7_block *block,
                      const tp_table_7_verdict *v) {
  static const tp_label_side sides[TP_TABLE_7_BLOCKS] = {TP_LABEL_ABOVE, TP_LABEL_CENTRE,
                                                         TP_LABEL_LEFT, TP_LABEL_RIGHT};
  /* below the line of the onset about a valley */
  const double away = sides[block->number - 1] == TP_LABEL_CENTRE ? 0.04 : 0;
  char number[16];
  snprintf(number, sizeof number, "%d", block->number);
  tp_chart_add_corner(d->chart, block->inverse_slenderness, block->tilt_deg);
  tp_chart_add_note(d->chart, 0, number);
  tp_chart_add_note(d->chart, 1, v->program);
  tp_chart_add_note(d->chart, 2, v->from_rest);
  tp_chart_add_note(d->chart, 3, v->paper);
  tp_chart_add_note(d->chart, 4, v->agrees ? "yes" : "no");
  tp_chart_add_label(d->chart, block->inverse_slenderness + away * d->x_most,
                     block->tilt_deg - away * d->y_most, sides[block->number - 1], number);
}

static tp_status add_blocks(const drawing *d, bool rough) {
  tp_status status = TP_OK;
  if (d->options->roughness_angle_deg < TP_TABLE_7_LEAST_ROUGHNESS) return status;
  begin_series(d, dots, "Table 7");
  for (int number = 1; number <= TP_TABLE_7_BLOCKS && status == TP_OK; number++) {
    const tp_table_7_block block = tp_table_7_locate(number, d->options);
    tp_table_7_verdict verdict = {0};
    status = tp_table_7_judge(&verdict, &block, d->options, rough, d->message);
    if (status == TP_OK) add_block(d, &block, &verdict);
  }
  return status;
}

static tp_status add_panel(drawing *d, bool rough) {
  const tp_chart_mechanisms_options *o = d->options;
  const double sliding = o->friction_deg + (rough ? o->roughness_angle_deg : 0);
  char title[160];
  d->panel = rough ? "rough" : "planar";
  if (rough) {
    snprintf(title, sizeof title,
             "(b) Rough base: {/:Italic φ_b} + {/:Italic i} = %.4g°, {/:Italic A/y} = %.4g %%",
             sliding, 100 * o->amplitude);
  } else {
    snprintf(title, sizeof title, "(a) Planar base: {/:Italic φ_b} = %.4g°", sliding);
  }
  tp_chart_add_panel(
      d->chart, title,
      (tp_panel_axis){.label = "Inverse slenderness {/:Italic Δx/y} (–)", .range = {0, d->x_most}},
      (tp_panel_axis){.label = rough ? NULL : "Tilt angle {/:Italic α} (°)",
                      .range = {0, d->y_most},
                      .tick = 10});
  add_regions(d, sliding, rough);
  add_sliding(d, sliding);
  tp_status status = TP_OK;
  if (rough) {
    status = add_toppling(d, TP_TOE_PEAK, line_peak);
    if (status == TP_OK) status = add_toppling(d, TP_TOE_VALLEY, line_valley);
  } else {
    status = add_toppling(d, TP_TOE_PLANAR, tp_line_topples);
  }
  const tp_mechanisms_rest rest = {d->chart, o, d->panel, d->x_most, d->y_most};
  if (status == TP_OK) {
    status = rough ? tp_mechanisms_rest_rough(&rest, d->message)
                   : tp_mechanisms_rest_planar(&rest, d->message);
  }
  return status == TP_OK ? add_blocks(d, rough) : status;
}

static void add_legend(tp_chart *chart) {
  const struct entry {
    const char *text;
    tp_chart_style style;
  } entries[] = {
      {"slides", tp_line_slides},
      {"topples, planar base", tp_line_topples},
      {"topples about a peak", line_peak},
      {"topples about a valley", line_valley},
      {"between motions from rest, planar or peak", tp_line_dynamic},
      {"between motions from rest, valley", tp_line_dynamic_valley},
      {"certain to stand up to, valley", tp_line_onset},
      {"blocks of Table 7", dots},
  };
  for (size_t e = 0; e < sizeof entries / sizeof entries[0]; e++) {
    bool any = false;
    for (size_t k = 0; k < chart->series_count && !any; k++) {
      const tp_chart_style *own = &chart->series[k].style;
      any = !chart->series[k].drawn_only && own->mark == entries[e].style.mark &&
            own->colour == entries[e].style.colour && own->dash == entries[e].style.dash;
    }
    if (any) tp_chart_add_legend(chart, entries[e].text, entries[e].style);
  }
}

tp_status tp_chart_mechanisms(tp_chart **chart, const tp_chart_mechanisms_options *options,
                              tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, options);
  tp_chart_mechanisms_options own = tp_chart_mechanisms_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  tp_status status = check(options, message);
  if (status != TP_OK) return status;
  const double most = options->friction_deg + options->roughness_angle_deg;
  drawing d = {.options = options,
               .message = message,
               .x_most = 0.2 * ceil(7.5 * tan(most / tp_degrees_of_radian)),
               .y_most = fmin(90, 10 * ceil(0.15 * most))};
  d.chart = tp_chart_new(
      "mechanisms", (const char *const[]){"base", "series", NULL}, "inverse_slenderness",
      "tilt_deg", (const char *const[]){"block", "program", "from_rest", "paper", "agrees", NULL});
  if (d.chart == NULL) return tp_fail_memory(message, "the chart");
  d.chart->columns = 2;
  d.chart->panel_width_mm = 72;
  d.chart->panel_height_mm = 62;
  status = add_panel(&d, false);
  if (status == TP_OK) status = add_panel(&d, true);
  if (status != TP_OK) {
    tp_chart_free(d.chart);
    return status;
  }
  add_legend(d.chart);
  return tp_chart_finish(d.chart, chart, message);
}
