/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Probability against tilt. Below its onset a sample is certain to stand, beyond its static limit
 * certain to move; of one whose limit is not known it is not certain that it moves, of one whose
 * onset is not, not that it stands. So the probability of moving lies between the share of limits
 * below the tilt and the share of onsets below it or unknown, each with Wilson's interval. The
 * shares that the study counted at its tilts stand there as points. */

#include "statistics/proportion.h"
#include "study/chart_panels.h"

#include <math.h>
#include <stdlib.h>

enum { TILTS = 181 };
static const double confidence = 0.95;

static const tp_chart_style moves_line = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_SOLID, 0};
static const tp_chart_style may_line = {TP_MARK_LINE, TP_COLOUR_BLUE, TP_DASH_DASHED, 0};
static const tp_chart_style moves_points = {TP_MARK_POINTS, TP_COLOUR_VERMILLION, TP_DASH_SOLID, 0};
static const tp_chart_style may_points = {TP_MARK_POINTS, TP_COLOUR_BLUE, TP_DASH_SOLID, 0};
static const tp_chart_style whisker = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0.5};
static const tp_chart_style at_tilt = {TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_DOTTED, 0.8};

static int compare(const void *one, const void *other) {
  const double a = *(const double *)one, b = *(const double *)other;
  return (a > b) - (a < b);
}

/* What is not known comes first, and counts as below every tilt, or is left out. */
static double *sort(size_t *count, const double *angles, size_t kept, bool unknown_counts) {
  double *sorted = calloc(kept + 1, sizeof *sorted);
  *count = 0;
  for (size_t k = 0; sorted != NULL && k < kept; k++) {
    if (!isnan(angles[k])) {
      sorted[(*count)++] = angles[k];
    } else if (unknown_counts) {
      sorted[(*count)++] = -INFINITY;
    }
  }
  if (sorted != NULL) qsort(sorted, *count, sizeof *sorted, compare);
  return sorted;
}

static void add_curve(tp_chart *chart, const tp_study_view *v, const double *sorted, size_t count,
                      tp_chart_range tilts, tp_chart_style style, const char *name) {
  double x[TILTS], low[TILTS], high[TILTS], share[TILTS];
  size_t below = 0;
  for (int k = 0; k < TILTS; k++) {
    x[k] = tilts.from + (tilts.to - tilts.from) * k / (TILTS - 1);
    while (below < count && sorted[below] < x[k]) below++;
    const tp_estimate own = tp_proportion(below, v->kept, confidence);
    share[k] = own.value;
    low[k] = own.low;
    high[k] = own.high;
  }
  tp_study_add_band(chart, style.colour, x, low, high, TILTS);
  tp_chart_add_series(chart, style, (const char *const[]){"fragility", name});
  for (int k = 0; k < TILTS; k++) {
    tp_chart_add_point(chart, tp_chart_exactly(x[k]), tp_chart_exactly(share[k]));
    tp_study_add_interval(chart, low[k], high[k]);
  }
}

static void add_whisker(tp_chart *chart, double x, double low, double high) {
  tp_chart_add_guide(chart, whisker);
  tp_chart_add_corner(chart, x, low);
  tp_chart_add_corner(chart, x, high);
}

static void add_counted(tp_chart *chart, const tp_study_result *r, bool stands) {
  if (r->tilt_count < 2) return;
  for (size_t k = 1; k < r->tilt_count; k++) {
    const tp_study_share *own =
        stands ? &r->tilts[k].certain_to_stand : &r->tilts[k].certain_to_move;
    add_whisker(chart, r->tilts[k].tilt_deg, stands ? 1 - own->high : own->low,
                stands ? 1 - own->low : own->high);
  }
  tp_chart_add_series(chart, stands ? may_points : moves_points,
                      (const char *const[]){"fragility, counted",
                                            stands ? "not certain to stand" : "certain to move"});
  for (size_t k = 1; k < r->tilt_count; k++) {
    const tp_study_share *own =
        stands ? &r->tilts[k].certain_to_stand : &r->tilts[k].certain_to_move;
    tp_chart_add_point(chart, tp_chart_exactly(r->tilts[k].tilt_deg),
                       tp_chart_exactly(stands ? 1 - own->share : own->share));
    tp_study_add_interval(chart, stands ? 1 - own->high : own->low,
                          stands ? 1 - own->low : own->high);
  }
}

static void add_own_tilt(tp_chart *chart, const tp_study_tilt *tilt, tp_chart_range range) {
  if (!tilt->has_tilt || !(tilt->tilt_deg > range.from && tilt->tilt_deg < range.to)) return;
  tp_chart_add_guide(chart, at_tilt);
  tp_chart_add_corner(chart, tilt->tilt_deg, 0);
  tp_chart_add_corner(chart, tilt->tilt_deg, 1);
}

/* All angles that are finite, and the tilts of the study, within 0 to 90. */
static tp_chart_range range_of(const tp_study_view *v, const double *onsets) {
  const tp_study_result *r = v->result;
  double least = v->least, greatest = v->greatest;
  for (size_t k = 0; k < v->kept; k++) {
    if (!isfinite(onsets[k])) continue;
    least = fmin(least, onsets[k]);
    greatest = fmax(greatest, onsets[k]);
  }
  for (size_t k = r->tilts[0].has_tilt ? 0 : 1; k < r->tilt_count; k++) {
    least = fmin(least, r->tilts[k].tilt_deg);
    greatest = fmax(greatest, r->tilts[k].tilt_deg);
  }
  const tp_chart_range own = tp_study_range(least, greatest);
  return (tp_chart_range){fmax(0, floor(own.from)), fmin(90, ceil(own.to))};
}

bool tp_study_add_fragility(tp_chart *chart, const tp_study_view *v) {
  if (v->finite == 0 || v->quantity != TP_STUDY_LIMIT_DEG) return true;
  const tp_study_result *r = v->result;
  const double *onsets = r->columns[r->variable_count + TP_STUDY_ONSET_DEG].values;
  const tp_chart_range range = range_of(v, onsets);
  size_t limit_count = 0, onset_count = 0;
  double *limits = sort(&limit_count, v->angles_deg, v->kept, false);
  double *sorted = sort(&onset_count, onsets, v->kept, true);
  const bool done = limits != NULL && sorted != NULL;
  if (done) {
    const bool lies = r->tilts[0].as_it_lies;
    tp_chart_add_panel(chart,
                       lies ? "Probability against the dip that it is steepened to, with 95 % bands"
                            : "Probability against tilt, with 95 % bands",
                       (tp_panel_axis){.label = lies ? "Dip (°)" : "Tilt (°)", .range = range},
                       (tp_panel_axis){.label = "Probability", .range = {0, 1}, .tick = 0.2});
    add_own_tilt(chart, r->tilts, range);
    add_curve(chart, v, limits, limit_count, range, moves_line, "certain to move");
    add_curve(chart, v, sorted, onset_count, range, may_line, "not certain to stand");
    add_counted(chart, r, true);
    add_counted(chart, r, false);
    tp_chart_add_legend(chart, "certain to move", moves_line);
    tp_chart_add_legend(chart, "not certain to stand", may_line);
    if (r->tilts[0].has_tilt) tp_chart_add_legend(chart, "the scene's tilt", at_tilt);
  }
  free(limits);
  free(sorted);
  return done;
}
