/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a study came to, as panels of a chart: fragility, distribution, ranks and steps, and its
 * samples against what varies. Of the samples kept (tp_study_result.kept); what has no angle, or
 * one at every tilt or at none, is counted, never drawn at an end. */

#ifndef TP_STUDY_CHART_PANELS_H
#define TP_STUDY_CHART_PANELS_H

#include "chart/chart.h"

/* A study, and what of it is drawn. */
typedef struct tp_study_view {
  const tp_study_result *result;
  size_t kept;
  tp_study_quantity quantity; /* the static limit; where no sample has one, by moments */
  const double *angles_deg;   /* of that, of each sample kept, */
  const double *outcomes;     /* and what becomes of it at the first tilt */
  double least, greatest;     /* of the angles that are finite; NaN: there is none */
  size_t finite;              /* how many are */
} tp_study_view;

tp_study_view tp_study_view_of(const tp_study_result *result);
/* The same of the critical angle by moments. */
tp_study_view tp_study_view_of_moments(const tp_study_result *result);

/* "Static limit (°)" */
const char *tp_study_angle_label(const tp_study_view *view);

/* "Certain to move at 22°"; `otherwise` of a scene without a tilt. */
void tp_study_tilt_name(char *text, size_t size, const tp_study_view *view, const char *what,
                        const char *otherwise);

/* How an outcome is told apart from others: regions, and points. */
tp_chart_style tp_study_region(tp_study_outcome outcome);
tp_chart_style tp_study_chart_points(tp_study_outcome outcome);

/* A design value; the angles of Eqs. (15) and (16). */
extern const tp_chart_style tp_study_design_line, tp_study_bound_line, tp_study_bound_points;

/* The range of the numbers, a little wider; of one number alone wider all the same. */
tp_chart_range tp_study_range(double least, double greatest);

/* The interval of the last point, as its notes. */
void tp_study_add_interval(tp_chart *chart, double low, double high);
/* A band from `low` to `high` over `x`, in the tint of a colour. */
void tp_study_add_band(tp_chart *chart, tp_chart_colour colour, const double *x, const double *low,
                       const double *high, size_t count);

/* A panel each. False when memory is exhausted; where there is nothing to show, no panel. */
TP_MUST_USE bool tp_study_add_fragility(tp_chart *chart, const tp_study_view *view);
TP_MUST_USE bool tp_study_add_distribution(tp_chart *chart, const tp_study_view *view);
void tp_study_add_ranks(tp_chart *chart, const tp_study_view *view);
TP_MUST_USE bool tp_study_add_steps(tp_chart *chart, const tp_study_view *view);
void tp_study_add_scatter(tp_chart *chart, const tp_study_view *view, size_t variable);
/* Of the critical angle by moments; are the angles of Eqs. (15) and (16) curves or points? */
TP_MUST_USE bool tp_study_add_roughness(tp_chart *chart, const tp_study_view *moments,
                                        size_t measure, bool *has_curves, bool *has_points);

#endif
