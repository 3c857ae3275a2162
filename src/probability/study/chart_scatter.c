/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The angle of each sample against a number that varies, parted by what becomes of it. Of more than
 * some thousands every n-th is drawn. */

#include "common/outside.h"
#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_DRAWN = 3000 };

const tp_chart_style tp_study_design_line = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_DASHED, 1};

/* Every so many. */
static size_t stride(const tp_study_view *v) {
  return (v->kept + MOST_DRAWN - 1) / MOST_DRAWN;
}

static void add_points(tp_chart *chart, const tp_study_view *v, const double *values,
                       const char *name, tp_study_outcome outcome) {
  bool begun = false;
  for (size_t k = 0; k < v->kept; k += stride(v)) {
    if ((int)v->outcomes[k] != (int)outcome || !isfinite(v->angles_deg[k])) continue;
    if (!begun) {
      tp_chart_add_series(chart, tp_study_chart_points(outcome),
                          (const char *const[]){name, tp_study_outcome_name(outcome)});
    }
    begun = true;
    tp_chart_add_point(chart, tp_chart_exactly(values[k]), tp_chart_exactly(v->angles_deg[k]));
  }
}

/* From the angle that the scene has with a design value, to it, and down. */
static void add_corner(tp_chart *chart, const tp_study_design *own, tp_chart_range x,
                       tp_chart_range y) {
  const bool level =
      own->quantity != TP_STUDY_FOS && own->quantity_value >= y.from && own->quantity_value <= y.to;
  tp_chart_add_guide(chart, tp_study_design_line);
  if (level) tp_chart_add_corner(chart, x.from, own->quantity_value);
  tp_chart_add_corner(chart, own->value, level ? own->quantity_value : y.to);
  tp_chart_add_corner(chart, own->value, y.from);
}

static void add_designs(tp_chart *chart, const tp_study_view *v, size_t variable, tp_chart_range x,
                        tp_chart_range y) {
  for (size_t k = 0; k < v->result->design_value_count; k++) {
    const tp_study_design *own = v->result->design_values + k;
    if (own->variable == variable && own->known) add_corner(chart, own, x, y);
  }
}

/* Of the samples, and of the design values. */
static tp_chart_range range_of(const tp_study_view *v, size_t variable) {
  double least = v->result->variables[variable].least;
  double greatest = v->result->variables[variable].greatest;
  for (size_t k = 0; k < v->result->design_value_count; k++) {
    const tp_study_design *own = v->result->design_values + k;
    if (own->variable != variable || !own->known) continue;
    least = fmin(least, own->value);
    greatest = fmax(greatest, own->value);
  }
  return tp_study_range(least, greatest);
}

/* "Each sample; design value for 5 %" */
static void name_panel(char *title, size_t size, const tp_study_view *v, size_t variable) {
  const char *before = "; design value for ";
  int used = stride(v) > 1 ? snprintf(title, size, "One of %zu samples", stride(v))
                           : snprintf(title, size, "Each sample");
  for (size_t k = 0; k < v->result->design_value_count && (size_t)used < size; k++) {
    const tp_study_design *own = v->result->design_values + k;
    if (own->variable != variable || !own->known) continue;
    used +=
        snprintf(title + used, size - (size_t)used, "%s%.3g %%", before, 100 * own->probability);
    before = ", ";
  }
}

/* "block.slab.height (m)"; the unit is not said twice where the key ends in it, as
 * friction_angle_deg. */
static void write_label(char *label, size_t size, const tp_study_variable *own,
                        const char *header) {
  const int shown = (int)tp_whole_characters(own->key, 60);
  const bool said = strcmp(own->key, header) == 0;
  if (own->unit == NULL || said) {
    snprintf(label, size, "%.*s", shown, own->key);
  } else {
    snprintf(label, size, "%.*s (%.8s)", shown, own->key, own->unit);
  }
}

void tp_study_add_scatter(tp_chart *chart, const tp_study_view *v, size_t variable) {
  const tp_study_variable *own = v->result->variables + variable;
  const double *values = v->result->columns[variable].values;
  const tp_chart_range x = range_of(v, variable), y = tp_study_range(v->least, v->greatest);
  char label[96], title[64];
  write_label(label, sizeof label, own, v->result->columns[variable].header);
  name_panel(title, sizeof title, v, variable);
  tp_chart_add_panel(chart, title, (tp_panel_axis){.label = label, .plain = true, .range = x},
                     (tp_panel_axis){.label = tp_study_angle_label(v), .range = y});
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    add_points(chart, v, values, own->key, (tp_study_outcome)k);
  }
  add_designs(chart, v, variable, x, y);
}
