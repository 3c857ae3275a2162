/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The angle of each sample against a number that varies, parted by what becomes of it. Of more than
 * some thousands every n-th is drawn. */

#include "outside.h"
#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_DRAWN = 3000 };

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
  char label[96], title[64];
  write_label(label, sizeof label, own, v->result->columns[variable].header);
  snprintf(title, sizeof title, stride(v) > 1 ? "One of %zu samples" : "Each sample", stride(v));
  tp_chart_add_panel(chart, title,
                     (tp_panel_axis){.label = label,
                                     .plain = true,
                                     .range = tp_study_range(own->least, own->greatest)},
                     (tp_panel_axis){.label = tp_study_angle_label(v),
                                     .range = tp_study_range(v->least, v->greatest)});
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    add_points(chart, v, values, own->key, (tp_study_outcome)k);
  }
}
