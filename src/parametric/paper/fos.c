/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Factor of safety against tilt (Fig. 16 of Alejano et al.): FoS = tan(alpha_crit) cot(alpha),
 * about a planar base by Eq. (17), about a peak by Eq. (15), about a valley by Eq. (16) with
 * A^2/(12 y^2); or with the alpha_crit of the exact block. The examples of Table 6 lie on the
 * curves. */

#include "chart/chart.h"
#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "paper/table_6.h"
#include "paper/teeth.h"

#include <math.h>
#include <stdio.h>

enum { POINTS = 111, PANELS_MAX = 12 };

static const tp_chart_colour colours[TP_CHART_LIST_MAX] = {TP_COLOUR_BLUE,   TP_COLOUR_VERMILLION,
                                                           TP_COLOUR_GREEN,  TP_COLOUR_PURPLE,
                                                           TP_COLOUR_ORANGE, TP_COLOUR_SKY_BLUE};
static const tp_chart_dash dashes[3] = {TP_DASH_SOLID, TP_DASH_DASHED, TP_DASH_DOTTED};
static const char *const toe_legend[3] = {"planar base", "peak axis", "valley axis"};
static const double fos_most = 3;

TP_OPTIONS_END(tp_chart_fos_options, tilt_deg);

static const double slendernesses[] = {0.5, 0.75, 1}, amplitudes[] = {0.1};

void tp_chart_fos_options_init(tp_chart_fos_options *options, size_t size) {
  const tp_chart_fos_options defaults = {.size = sizeof defaults,
                                         .inverse_slenderness = {3, slendernesses},
                                         .amplitude = {1, amplitudes},
                                         .tilt_deg = {5, 60}};
  tp_options_fill(options, size, &defaults);
}

typedef struct drawing {
  tp_chart *chart;
  const tp_chart_fos_options *options;
  tp_message *message;
  tp_toothed block; /* of the present curve; no sub-blocks: by the equations */
} drawing;

static tp_status check_list(const tp_chart_list *list, const char *name, double least, double most,
                            tp_message *message) {
  if (list->count > TP_CHART_LIST_MAX) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "%s: %zu of them; a list holds at most %d", name, list->count,
                     (int)TP_CHART_LIST_MAX);
  }
  if (list->count > 0 && list->values == NULL) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "%s: the list is NULL", name);
  }
  for (size_t k = 0; k < list->count; k++) {
    if (list->values[k] >= least && list->values[k] <= most) continue;
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "%s of %g: it must lie between %g and %g", name, list->values[k], least, most);
  }
  return TP_OK;
}

static tp_status check(const tp_chart_fos_options *o, tp_message *message) {
  if (o->inverse_slenderness.count == 0 || o->amplitude.count == 0) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "give an inverse slenderness and a relative amplitude at least");
  }
  tp_status status =
      check_list(&o->inverse_slenderness, "an inverse slenderness", 1e-3, 10, message);
  if (status == TP_OK) status = check_list(&o->amplitude, "a relative amplitude", 0, 0.5, message);
  if (status == TP_OK)
    status = check_list(&o->sub_blocks, "a number of sub-blocks", 2, 1000, message);
  for (size_t k = 0; k < o->sub_blocks.count && status == TP_OK; k++) {
    if (o->sub_blocks.values[k] == floor(o->sub_blocks.values[k])) continue;
    status = tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                       "a number of sub-blocks of %g: it must be whole", o->sub_blocks.values[k]);
  }
  if (status != TP_OK) return status;
  const tp_chart_range *tilt = &o->tilt_deg;
  if (!(tilt->from > 0 && tilt->from < tilt->to && tilt->to < 90)) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "the tilt goes from %g to %g; it must rise, and lie between 0 and 90 degrees",
                     tilt->from, tilt->to);
  }
  const size_t rows = o->sub_blocks.count > 0 ? o->sub_blocks.count : 1;
  if (rows * o->amplitude.count > PANELS_MAX) {
    return tp_refuse(
        message, TP_FAULT_RANGE, (tp_place){0},
        "%zu panels; at most %d can be read on a page: give fewer amplitudes or numbers "
        "of sub-blocks",
        rows * o->amplitude.count, PANELS_MAX);
  }
  return TP_OK;
}

static tp_status tangent(tp_bounded *value, const drawing *d, tp_toe_kind toe) {
  if (d->block.sub_blocks == 0) {
    *value = tp_toothed_tangent(&d->block, toe);
    return TP_OK;
  }
  tp_bounded degrees = {0};
  const tp_status status = tp_toothed_critical_angle(&degrees, &d->block, toe, d->message);
  if (status == TP_OK) *value = tp_tangent_deg(degrees);
  return status;
}

static void begin_series(const drawing *d, tp_chart_style style, const char *series,
                         tp_toe_kind toe) {
  char slenderness[32], amplitude[32], count[32] = "";
  snprintf(slenderness, sizeof slenderness, "%.15g", d->block.inverse_slenderness);
  snprintf(amplitude, sizeof amplitude, "%.15g", d->block.amplitude);
  if (d->block.sub_blocks > 0) snprintf(count, sizeof count, "%zu", d->block.sub_blocks);
  tp_chart_add_series(
      d->chart, style,
      (const char *const[]){series, slenderness, amplitude, count, tp_toe_names[toe], NULL});
}

static void add_curve(const drawing *d, tp_toe_kind toe, tp_bounded critical,
                      tp_chart_colour colour) {
  const tp_chart_range *tilt = &d->options->tilt_deg;
  begin_series(d, (tp_chart_style){TP_MARK_LINE, colour, dashes[toe], 0}, "curve", toe);
  for (int k = 0; k < POINTS; k++) {
    const tp_bounded angle =
        tp_chart_exactly(tilt->from + (tilt->to - tilt->from) * k / (POINTS - 1));
    tp_chart_add_point(d->chart, angle, tp_quotient(critical, tp_tangent_deg(angle)));
  }
}

static void add_examples(const drawing *d, tp_toe_kind toe, tp_bounded critical) {
  for (int k = 0; k < TP_TABLE_6_EXAMPLES; k++) {
    const tp_table_6_example *e = tp_table_6 + k;
    const tp_bounded angle = tp_chart_exactly(e->tilt_deg);
    if (e->inverse_slenderness != d->block.inverse_slenderness ||
        e->amplitude != d->block.amplitude) {
      continue;
    }
    begin_series(d, (tp_chart_style){TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0}, "Table 6",
                 toe);
    tp_chart_add_point(d->chart, angle, tp_quotient(critical, tp_tangent_deg(angle)));
    tp_chart_add_note(d->chart, 0, e->printed[toe]);
  }
}

/* The inverse slenderness stands where its planar curve meets the upper border, if there is room
 * behind what stands to its left. */
static void add_slenderness_labels(const drawing *d) {
  const tp_chart_range *tilt = &d->options->tilt_deg;
  const double per_mm = tilt->to / d->chart->panel_width_mm, room = 5 * per_mm;
  double free_from = 8 * per_mm;
  bool any = false;
  for (size_t k = 0; k < d->options->inverse_slenderness.count; k++) {
    const double x = d->options->inverse_slenderness.values[k],
                 at = atan(x / fos_most) * tp_degrees_of_radian;
    char text[32];
    snprintf(text, sizeof text, "%.4g", x);
    if (at < tilt->from || at > tilt->to || at - room / 2 < free_from) continue;
    tp_chart_add_label(d->chart, at, fos_most, TP_LABEL_ABOVE, text);
    free_from = at + room / 2;
    any = true;
  }
  if (any) tp_chart_add_label(d->chart, 0, fos_most, TP_LABEL_ALONG, "{/:Italic Δx/y} =");
}

/* Only panels of the left and of the lowest row name their axes. */
static tp_status add_panel(drawing *d, double amplitude, size_t sub_blocks, bool left,
                           bool lowest) {
  const tp_chart_fos_options *o = d->options;
  char title[80];
  const int length = snprintf(title, sizeof title, "{/:Italic A/y} = %.4g %%", 100 * amplitude);
  if (sub_blocks > 0) {
    snprintf(title + length, sizeof title - (size_t)length, ", {/:Italic N} = %zu", sub_blocks);
  }
  tp_chart_add_panel(d->chart, title,
                     (tp_panel_axis){.label = lowest ? "Tilt angle {/:Italic α} (°)" : NULL,
                                     .range = {0, o->tilt_deg.to},
                                     .tick = 10},
                     (tp_panel_axis){.label = left ? "Factor of safety {/:Italic FoS} (–)" : NULL,
                                     .range = {0, fos_most},
                                     .tick = 0.5});
  tp_chart_add_guide(d->chart, (tp_chart_style){TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_SOLID, 0.6});
  tp_chart_add_corner(d->chart, 0, 1);
  tp_chart_add_corner(d->chart, o->tilt_deg.to, 1);
  for (size_t k = 0; k < o->inverse_slenderness.count; k++) {
    d->block = (tp_toothed){o->inverse_slenderness.values[k], amplitude, sub_blocks};
    for (int toe = 0; toe < 3; toe++) {
      tp_bounded critical = {0};
      const tp_status status = tangent(&critical, d, (tp_toe_kind)toe);
      if (status != TP_OK) return status;
      add_curve(d, (tp_toe_kind)toe, critical, colours[k]);
      add_examples(d, (tp_toe_kind)toe, critical);
    }
  }
  add_slenderness_labels(d);
  return TP_OK;
}

static void add_legend(const drawing *d) {
  for (size_t k = 0; k < d->options->inverse_slenderness.count; k++) {
    char text[64];
    snprintf(text, sizeof text, "{/:Italic Δx/y} = %.4g",
             d->options->inverse_slenderness.values[k]);
    tp_chart_add_legend(d->chart, text,
                        (tp_chart_style){TP_MARK_LINE, colours[k], TP_DASH_SOLID, 0});
  }
  for (int toe = 0; toe < 3; toe++) {
    tp_chart_add_legend(d->chart, toe_legend[toe],
                        (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, dashes[toe], 0});
  }
  for (size_t k = 0; k < d->chart->series_count; k++) {
    const tp_chart_style *style = &d->chart->series[k].style;
    if (style->mark != TP_MARK_POINTS) continue;
    tp_chart_add_legend(d->chart, "Table 6", *style);
    break;
  }
}

tp_status tp_chart_fos(tp_chart **chart, const tp_chart_fos_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, options);
  tp_chart_fos_options own = tp_chart_fos_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  tp_status status = check(options, message);
  if (status != TP_OK) return status;
  const size_t rows = options->sub_blocks.count > 0 ? options->sub_blocks.count : 1;
  drawing d = {.options = options, .message = message};
  d.chart = tp_chart_new("fos",
                         (const char *const[]){"series", "inverse_slenderness", "amplitude",
                                               "sub_blocks", "axis", NULL},
                         "tilt_deg", "fos", (const char *const[]){"printed", NULL});
  if (d.chart == NULL) return tp_fail_memory(message, "the chart");
  d.chart->columns = options->amplitude.count;
  d.chart->panel_width_mm = options->amplitude.count > 1 ? 60 : 72;
  d.chart->panel_height_mm = 58;
  for (size_t row = 0; row < rows && status == TP_OK; row++) {
    for (size_t k = 0; k < options->amplitude.count && status == TP_OK; k++) {
      const size_t count =
          options->sub_blocks.count > 0 ? (size_t)options->sub_blocks.values[row] : 0;
      status = add_panel(&d, options->amplitude.values[k], count, k == 0, row + 1 == rows);
    }
  }
  if (status != TP_OK) {
    tp_chart_free(d.chart);
    return status;
  }
  add_legend(&d);
  return tp_chart_finish(d.chart, chart, message);
}
