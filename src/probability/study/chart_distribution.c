/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How the angle at which a block begins to move is distributed: a histogram of bins of the width 2
 * IQR n^(-1/3) (Freedman and Diaconis, Z. Wahrscheinlichkeitstheorie 57 (1981) 453-476), 5 to 60 of
 * them, in shares of all samples kept, parted by what becomes of each. */

#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LEAST_BINS = 5, MOST_BINS = 60 };

typedef struct histogram {
  double from, width;
  size_t bins;
  size_t counts[TP_STUDY_OUTCOMES][MOST_BINS];
} histogram;

/* The study's own quartiles. */
static double quartile_range(const tp_study_view *v) {
  const tp_study_spread *spread = v->result->quantities + v->quantity;
  double low = NAN, high = NAN;
  for (size_t k = 0; k < TP_STUDY_QUANTILES; k++) {
    if (spread->quantiles[k].probability == 0.25) low = spread->quantiles[k].value;
    if (spread->quantiles[k].probability == 0.75) high = spread->quantiles[k].value;
  }
  return high - low;
}

static void count_bins(histogram *h, const tp_study_view *v) {
  const double spread = v->greatest - v->least;
  const double wanted = 2 * quartile_range(v) / cbrt((double)v->finite);
  const double bins = wanted > 0 && isfinite(wanted) ? ceil(spread / wanted) : LEAST_BINS;
  h->bins = (size_t)fmin(fmax(bins, LEAST_BINS), MOST_BINS);
  h->from = spread > 0 ? v->least : v->least - 0.5;
  h->width = (spread > 0 ? spread : 1) / (double)h->bins;
  for (size_t k = 0; k < v->kept; k++) {
    if (!isfinite(v->angles_deg[k])) continue;
    const double at = floor((v->angles_deg[k] - h->from) / h->width);
    const size_t bin = at > 0 ? (size_t)at : 0;
    h->counts[(int)v->outcomes[k]][bin < h->bins ? bin : h->bins - 1]++;
  }
}

/* Around what is stacked so far, so that the parts are told apart in print. */
static void add_outline(tp_chart *chart, const tp_study_view *v, const histogram *h,
                        const size_t heights[MOST_BINS]) {
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0.5});
  tp_chart_add_corner(chart, h->from, 0);
  for (size_t k = 0; k < h->bins; k++) {
    const double height = (double)heights[k] / (double)v->kept;
    tp_chart_add_corner(chart, h->from + h->width * (double)k, height);
    tp_chart_add_corner(chart, h->from + h->width * (double)(k + 1), height);
  }
  tp_chart_add_corner(chart, h->from + h->width * (double)h->bins, 0);
}

/* Upon those before it, of which `base` is the height. */
static void add_bars(tp_chart *chart, const tp_study_view *v, const histogram *h, int outcome,
                     size_t base[MOST_BINS]) {
  const double all = (double)v->kept;
  const char *name = tp_study_outcome_name((tp_study_outcome)outcome);
  tp_chart_add_guide(chart, tp_study_region((tp_study_outcome)outcome));
  for (size_t k = 0; k < h->bins; k++) {
    const double left = h->from + h->width * (double)k, right = left + h->width;
    const double low = (double)base[k] / all;
    base[k] += h->counts[outcome][k];
    const double high = (double)base[k] / all;
    if (!(high > low)) continue;
    tp_chart_add_corner(chart, left, low);
    tp_chart_add_corner(chart, right, low);
    tp_chart_add_corner(chart, right, high);
    tp_chart_add_corner(chart, left, high);
    tp_chart_add_break(chart);
  }
  add_outline(chart, v, h, base);
  tp_chart_add_series(chart, (tp_chart_style){.mark = TP_MARK_NONE},
                      (const char *const[]){"distribution", name});
  for (size_t k = 0; k < h->bins; k++) {
    const double left = h->from + h->width * (double)k;
    tp_chart_add_point(chart, tp_chart_exactly(left + h->width / 2),
                       tp_chart_exactly((double)h->counts[outcome][k] / all));
  }
  tp_chart_add_legend(chart, name, tp_study_region((tp_study_outcome)outcome));
}

/* Samples that are in no bin. */
static void tell_others(tp_chart *chart, const tp_study_view *v, const histogram *h, double top) {
  char text[80];
  if (v->finite == v->kept) return;
  snprintf(text, sizeof text, "%.3g %% at every tilt, at none, or not known",
           100 * (double)(v->kept - v->finite) / (double)v->kept);
  tp_chart_add_label(chart, h->from, top, TP_LABEL_ALONG, text);
}

bool tp_study_add_distribution(tp_chart *chart, const tp_study_view *v) {
  if (v->finite == 0) return true;
  histogram *h = calloc(1, sizeof *h);
  size_t heights[MOST_BINS] = {0}, most = 0;
  if (h == NULL) return false;
  count_bins(h, v);
  for (size_t k = 0; k < h->bins; k++) {
    size_t sum = 0;
    for (int o = 0; o < TP_STUDY_OUTCOMES; o++) sum += h->counts[o][k];
    if (sum > most) most = sum;
  }
  char title[64];
  tp_study_tilt_name(title, sizeof title, v, "Distribution, by outcome",
                     "Distribution, by first motion");
  const double top = 1.12 * (double)most / (double)v->kept;
  tp_chart_add_panel(
      chart, title,
      (tp_panel_axis){.label = tp_study_angle_label(v),
                      .range = tp_study_range(h->from, h->from + h->width * (double)h->bins)},
      (tp_panel_axis){.label = "Share of samples", .range = {0, top}});
  for (int o = 0; o < TP_STUDY_OUTCOMES; o++) {
    size_t sum = 0;
    for (size_t k = 0; k < h->bins; k++) sum += h->counts[o][k];
    if (sum > 0) add_bars(chart, v, h, o, heights);
  }
  tell_others(chart, v, h, top / 1.08);
  free(h);
  return true;
}
