/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public calls that draw the summary and the scatter chart of a study from the panels of
 * study/chart_panels.h. */

#include "common/host.h"
#include "study/chart_panels.h"

static const char *const keys[] = {"panel_of", "of", NULL};
static const char *const notes[] = {"low", "high", NULL};

static tp_chart *begin(const char *kind, const tp_study_result *result) {
  tp_chart *own = tp_chart_new(kind, keys, "x", "y", notes);
  if (own == NULL) return NULL;
  if (result->title != NULL) tp_chart_set_title(own, result->title);
  for (size_t k = 0; k < result->source_count; k++) tp_chart_add_source(own, result->sources[k]);
  own->columns = 2;
  own->rows_are_named = true;
  own->panel_width_mm = 66;
  own->panel_height_mm = 50;
  return own;
}

static tp_status fail_empty(tp_message *message) {
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                 "no sample of the study has a critical angle: there is nothing to "
                 "draw");
}

tp_status tp_chart_study(tp_chart **chart, const tp_study_result *result, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, result);
  const tp_study_view view = tp_study_view_of(result);
  if (view.finite == 0) return fail_empty(message);
  tp_chart *own = begin("study", result);
  if (own == NULL) return tp_fail_memory(message, "the chart");
  own->failed |= !tp_study_add_fragility(own, &view);
  own->failed |= !tp_study_add_distribution(own, &view);
  tp_study_add_ranks(own, &view);
  own->failed |= !tp_study_add_steps(own, &view);
  return tp_chart_finish(own, chart, message);
}

tp_status tp_chart_study_scatter(tp_chart **chart, const tp_study_result *result,
                                 tp_message *message) {
  TP_GUARD_HOST;
  enum { MOST_PANELS = 8 };
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, result);
  const tp_study_view view = tp_study_view_of(result);
  if (view.finite == 0) return fail_empty(message);
  tp_chart *own = begin("study_scatter", result);
  if (own == NULL) return tp_fail_memory(message, "the chart");
  /* of what is measured the two bounds have no panel of their own */
  const size_t measures = result->roughness_count > 0 ? result->roughness_count - 2 : 0;
  const size_t room = MOST_PANELS - measures;
  const size_t count = result->variable_count < room ? result->variable_count : room;
  if (count + measures == 1) own->columns = 1;
  for (size_t k = 0; k < count; k++) tp_study_add_scatter(own, &view, k);
  const tp_study_view moments = tp_study_view_of_moments(result);
  bool curves = false, points = false;
  for (size_t k = 0; k < measures; k++) {
    own->failed |= !tp_study_add_roughness(own, &moments, k, &curves, &points);
  }
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    if (result->tilts[0].outcomes[k].samples == 0 || k == TP_STUDY_INVALID) continue;
    tp_chart_add_legend(own, tp_study_outcome_name((tp_study_outcome)k),
                        tp_study_chart_points((tp_study_outcome)k));
  }
  bool known = false;
  for (size_t k = 0; k < result->design_value_count; k++)
    known = known || result->design_values[k].known;
  if (known) tp_chart_add_legend(own, "design value", tp_study_design_line);
  if (curves) tp_chart_add_legend(own, "Eqs. (15), (16)", tp_study_bound_line);
  if (points) tp_chart_add_legend(own, "of each sample", tp_study_bound_points);
  return tp_chart_finish(own, chart, message);
}
