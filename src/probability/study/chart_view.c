/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Data that the charts of a study share: the column of critical angles, its range, labels with the
 * tilt, and colours and symbols of the outcomes. */

#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>

static void look_at(tp_study_view *v, tp_study_quantity quantity) {
  const tp_study_result *r = v->result;
  v->quantity = quantity;
  v->angles_deg = r->columns[r->variable_count + (size_t)quantity].values;
  v->least = v->greatest = NAN;
  v->finite = 0;
  for (size_t k = 0; k < v->kept; k++) {
    const double angle = v->angles_deg[k];
    if (!isfinite(angle)) continue;
    v->least = fmin(v->least, angle);
    v->greatest = fmax(v->greatest, angle);
    v->finite++;
  }
}

tp_study_view tp_study_view_of(const tp_study_result *result) {
  tp_study_view v = {.result = result, .kept = result->kept};
  const size_t quantities =
      result->of_many_blocks || result->of_solid ? TP_STUDY_QUANTITIES : TP_STUDY_FOS + 1;
  const size_t outcomes = result->variable_count + quantities;
  if (result->column_count <= outcomes) v.kept = 0; /* nothing was kept */
  v.least = v.greatest = NAN;
  if (v.kept == 0) return v;
  v.outcomes = result->columns[outcomes].values;
  look_at(&v, TP_STUDY_LIMIT_DEG);
  if (v.finite == 0) look_at(&v, TP_STUDY_MOMENTS_DEG);
  return v;
}

tp_study_view tp_study_view_of_moments(const tp_study_result *result) {
  tp_study_view v = tp_study_view_of(result);
  if (v.kept > 0) look_at(&v, TP_STUDY_MOMENTS_DEG);
  return v;
}

const char *tp_study_angle_label(const tp_study_view *view) {
  if (view->quantity != TP_STUDY_LIMIT_DEG) return "Critical angle by moments (°)";
  return view->result->of_many_blocks ? "Static limit (°), upper bound" : "Static limit (°)";
}

void tp_study_tilt_name(char *text, size_t size, const tp_study_view *view, const char *what,
                        const char *otherwise) {
  const tp_study_tilt *own = view->result->tilts;
  if (own->has_tilt) {
    snprintf(text, size, "%s at %.4g°", what, own->tilt_deg);
  } else if (own->as_it_lies) {
    snprintf(text, size, "%s as it lies", what);
  } else {
    snprintf(text, size, "%s", otherwise);
  }
}

static tp_chart_colour colour_of(tp_study_outcome outcome, bool points) {
  switch (outcome) {
  case TP_STUDY_STANDS:
    return TP_COLOUR_GREEN;
  case TP_STUDY_SLIDES:
    return points ? TP_COLOUR_BLUE : TP_COLOUR_SKY_BLUE;
  case TP_STUDY_TOPPLES:
    return points ? TP_COLOUR_VERMILLION : TP_COLOUR_ORANGE;
  case TP_STUDY_SLIDES_AND_TOPPLES:
    return TP_COLOUR_PURPLE;
  case TP_STUDY_MAY_MOVE:
    return points ? TP_COLOUR_ORANGE : TP_COLOUR_YELLOW;
  case TP_STUDY_LEAVES_BASE:
  case TP_STUDY_INTERLOCKED:
    return TP_COLOUR_BLACK;
  case TP_STUDY_UNDECIDED:
  case TP_STUDY_INVALID:
    break;
  }
  return TP_COLOUR_GREY;
}

tp_chart_style tp_study_region(tp_study_outcome outcome) {
  return (tp_chart_style){TP_MARK_REGION, colour_of(outcome, false), TP_DASH_SOLID, 0};
}

tp_chart_style tp_study_chart_points(tp_study_outcome outcome) {
  const tp_chart_dash symbol = outcome == TP_STUDY_SLIDES_AND_TOPPLES ? TP_DASH_DASHED
                               : outcome == TP_STUDY_STANDS           ? TP_DASH_DOTTED
                                                                      : TP_DASH_SOLID;
  return (tp_chart_style){TP_MARK_POINTS, colour_of(outcome, true), symbol, 0};
}

tp_chart_range tp_study_range(double least, double greatest) {
  const double spread = greatest - least;
  const double pad = spread > 0 ? 0.05 * spread : fmax(0.05 * fabs(least), 0.5);
  return (tp_chart_range){least - pad, greatest + pad};
}

void tp_study_add_interval(tp_chart *chart, double low, double high) {
  char text[32];
  snprintf(text, sizeof text, "%.15g", low);
  tp_chart_add_note(chart, 0, text);
  snprintf(text, sizeof text, "%.15g", high);
  tp_chart_add_note(chart, 1, text);
}

void tp_study_add_band(tp_chart *chart, tp_chart_colour colour, const double *x, const double *low,
                       const double *high, size_t count) {
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_REGION, colour, TP_DASH_SOLID, 0});
  for (size_t k = 0; k < count; k++) tp_chart_add_corner(chart, x[k], low[k]);
  for (size_t k = count; k-- > 0;) tp_chart_add_corner(chart, x[k], high[k]);
}
