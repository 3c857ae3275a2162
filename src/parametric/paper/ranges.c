/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Critical angles about peak and valley over the ranges of Fig. 14 of Alejano et al., of exact
 * blocks. N and lambda / dx are tied, N = 2 dx / lambda, so that the two lists of the figure are
 * two series: N = 2, 3, 4, 7, and lambda / dx = 1, 1/2, 1/5, 1/10, which is N = 2, 4, 10, 20. As
 * the angle of an even N does not depend on N, the lower panels show what an odd N adds to it. */

#include "chart/chart.h"
#include "common/host.h"
#include "common/message.h"
#include "paper/teeth.h"

#include <stdio.h>

enum { POINTS = 21, WIDTHS = 4, COUNTS = 4, MARKS = 4 };

static const double amplitude_most = 0.1;
static const double marks[MARKS] = {0.01, 0.02, 0.05, 0.1};
static const struct width {
  double inverse_slenderness;
  const char *text;
} widths[WIDTHS] = {{2.0 / 3, "2/3"}, {1.0 / 2, "1/2"}, {1.0 / 3, "1/3"}, {1.0 / 5, "1/5"}};

typedef struct list {
  const char *name;
  size_t sub_blocks[COUNTS];
  const char *wavelengths[COUNTS]; /* over dx */
} list;
static const list lists[2] = {
    {"N", {2, 3, 4, 7}, {"1", "2/3", "1/2", "2/7"}},
    {"wavelength", {2, 4, 10, 20}, {"1", "1/2", "1/5", "1/10"}},
};

typedef struct drawing {
  tp_chart *chart;
  tp_message *message;
  const struct width *width;
  const char *series;
} drawing;

static tp_bounded difference(tp_bounded a, tp_bounded b) {
  const double value = a.value - b.value;
  return (tp_bounded){.value = value,
                      .error = a.error + b.error + 0x1p-52 * (value < 0 ? -value : value)};
}

/* The angle at an amplitude; less that of N = 2 when `less_even`. */
static tp_status add_point(const drawing *d, size_t sub_blocks, tp_toe_kind toe, double amplitude,
                           bool less_even) {
  tp_bounded angle = {0}, even = {0};
  tp_toothed block = {d->width->inverse_slenderness, amplitude, sub_blocks};
  tp_status status = tp_toothed_critical_angle(&angle, &block, toe, d->message);
  block.sub_blocks = 2;
  if (status == TP_OK && less_even) {
    status = tp_toothed_critical_angle(&even, &block, toe, d->message);
    angle = difference(angle, even);
  }
  if (status == TP_OK) {
    const double percent = 100 * amplitude;
    tp_chart_add_point(d->chart, (tp_bounded){.value = percent, .error = percent * 0x1p-52}, angle);
  }
  return status;
}

/* A series of one number of sub-blocks and one toe. */
static void begin_series(const drawing *d, size_t sub_blocks, const char *wavelength,
                         tp_toe_kind toe, tp_chart_style style) {
  char count[24];
  snprintf(count, sizeof count, "%zu", sub_blocks);
  const char *keys[] = {d->series, d->width->text, count, wavelength, tp_toe_names[toe], NULL};
  tp_chart_add_series(d->chart, style, keys);
}

static tp_status add_curve(const drawing *d, size_t sub_blocks, const char *wavelength,
                           tp_toe_kind toe, tp_chart_style style, bool less_even) {
  tp_status status = TP_OK;
  begin_series(d, sub_blocks, wavelength, toe, style);
  for (int k = 0; k < POINTS && status == TP_OK; k++) {
    status = add_point(d, sub_blocks, toe, amplitude_most * k / (POINTS - 1), less_even);
  }
  return status;
}

/* The amplitudes of Fig. 14, on the curve of N. */
static tp_status add_marks(const drawing *d, size_t sub_blocks, const char *wavelength,
                           tp_toe_kind toe, tp_chart_style style, bool less_even) {
  tp_status status = TP_OK;
  style.mark = TP_MARK_POINTS;
  begin_series(d, sub_blocks, wavelength, toe, style);
  for (int k = 0; k < MARKS && status == TP_OK; k++) {
    status = add_point(d, sub_blocks, toe, marks[k], less_even);
    if (status == TP_OK) tp_chart_add_note(d->chart, 0, "Fig. 14");
  }
  return status;
}

static const tp_chart_colour peak_colour = TP_COLOUR_BLUE, valley_colour = TP_COLOUR_VERMILLION;

static tp_chart_style style_of(size_t sub_blocks, tp_toe_kind toe) {
  const tp_chart_colour colour = toe == TP_TOE_PEAK ? peak_colour : valley_colour;
  const tp_chart_dash dash = sub_blocks % 2 == 0 ? TP_DASH_SOLID
                             : sub_blocks == 3   ? TP_DASH_DASHED
                                                 : TP_DASH_DOTTED;
  return (tp_chart_style){TP_MARK_LINE, colour, dash, 0};
}

static tp_status add_series_of_list(drawing *d, const list *from, bool less_even) {
  tp_status status = TP_OK;
  d->series = less_even ? "odd less even" : from->name;
  for (size_t k = 0; k < COUNTS && status == TP_OK; k++) {
    const size_t count = from->sub_blocks[k];
    if (less_even && count % 2 == 0) continue;
    for (int toe = TP_TOE_PEAK; toe <= TP_TOE_VALLEY && status == TP_OK; toe++) {
      const tp_chart_style style = style_of(count, (tp_toe_kind)toe);
      status = add_curve(d, count, from->wavelengths[k], (tp_toe_kind)toe, style, less_even);
      if (status == TP_OK) {
        status = add_marks(d, count, from->wavelengths[k], (tp_toe_kind)toe, style, less_even);
      }
    }
  }
  return status;
}

static tp_status add_row(drawing *d, bool less_even) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < WIDTHS && status == TP_OK; k++) {
    char title[48];
    d->width = widths + k;
    snprintf(title, sizeof title, "{/:Italic Δx/y} = %s", widths[k].text);
    const double middle =
        (double[]){33.69006752597979, 26.56505117707799, 18.43494882292201, 11.309932474020213}[k];
    const tp_panel_axis y = {.label = k > 0       ? NULL
                                      : less_even ? "Odd less even {/:Italic N} (°)"
                                                  : "Critical angle {/:Italic α}_{crit} (°)",
                             .range = less_even ? (tp_chart_range){-0.06, 0.06}
                                                : (tp_chart_range){middle - 4, middle + 4},
                             .tick = less_even ? 0.02 : 2};
    tp_chart_add_panel(d->chart, less_even ? NULL : title,
                       (tp_panel_axis){.label = less_even ? "Amplitude {/:Italic A/y} (%)" : NULL,
                                       .range = {0, 100 * amplitude_most},
                                       .tick = 2},
                       y);
    status = add_series_of_list(d, lists, less_even);
    if (status == TP_OK && !less_even) status = add_series_of_list(d, lists + 1, false);
  }
  return status;
}

static void add_legend(tp_chart *chart) {
  tp_chart_add_legend(chart, "peak", (tp_chart_style){TP_MARK_LINE, peak_colour, TP_DASH_SOLID, 0});
  tp_chart_add_legend(chart, "valley",
                      (tp_chart_style){TP_MARK_LINE, valley_colour, TP_DASH_SOLID, 0});
  tp_chart_add_legend(chart, "{/:Italic N} = 2, 4, 10, 20",
                      (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0});
  tp_chart_add_legend(chart, "{/:Italic N} = 3",
                      (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DASHED, 0});
  tp_chart_add_legend(chart, "{/:Italic N} = 7",
                      (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DOTTED, 0});
  tp_chart_add_legend(chart, "Fig. 14",
                      (tp_chart_style){TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0});
}

tp_status tp_chart_ranges(tp_chart **chart, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  drawing d = {.message = message};
  d.chart = tp_chart_new("ranges",
                         (const char *const[]){"series", "inverse_slenderness", "sub_blocks",
                                               "wavelength_over_width", "axis", NULL},
                         "amplitude_percent", "angle_deg", (const char *const[]){"mark", NULL});
  if (d.chart == NULL) return tp_fail_memory(message, "the chart");
  d.chart->columns = WIDTHS;
  d.chart->panel_width_mm = 31;
  d.chart->panel_height_mm = 40;
  tp_status status = add_row(&d, false);
  if (status == TP_OK) status = add_row(&d, true);
  if (status != TP_OK) {
    tp_chart_free(d.chart);
    return status;
  }
  add_legend(d.chart);
  return tp_chart_finish(d.chart, chart, message);
}
