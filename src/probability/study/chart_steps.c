/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How the estimate settles as samples come in: the share that is certain to move, with Wilson's
 * interval. */

#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const tp_chart_style line = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_SOLID, 0};

static void add_estimates(tp_chart *chart, const tp_study_view *v, double *room) {
  const tp_study_result *r = v->result;
  const size_t count = r->convergence_count;
  double *x = room, *low = room + count, *high = room + 2 * count;
  double least = 1, greatest = 0;
  for (size_t k = 0; k < count; k++) {
    const tp_study_step *step = r->convergence + k;
    x[k] = (double)step->of_samples;
    low[k] = step->certain_to_move.low;
    high[k] = step->certain_to_move.high;
    least = fmin(least, low[k]);
    greatest = fmax(greatest, high[k]);
  }
  char label[64];
  tp_study_tilt_name(label, sizeof label, v, "Certain to move", "Certain to move at some tilt");
  const tp_chart_range y = tp_study_range(least, greatest);
  tp_chart_add_panel(
      chart, "Convergence, with its 95 % band",
      (tp_panel_axis){.label = "Samples", .range = {x[0], x[count - 1]}, .logarithmic = true},
      (tp_panel_axis){.label = label, .range = {fmax(0, y.from), fmin(1, y.to)}});
  tp_study_add_band(chart, line.colour, x, low, high, count);
  tp_chart_add_series(chart, line, (const char *const[]){"convergence", "certain to move"});
  for (size_t k = 0; k < count; k++) {
    tp_chart_add_point(chart, tp_chart_exactly(x[k]),
                       tp_chart_exactly(r->convergence[k].certain_to_move.share));
    tp_study_add_interval(chart, low[k], high[k]);
  }
}

bool tp_study_add_steps(tp_chart *chart, const tp_study_view *v) {
  const tp_study_result *r = v->result;
  if (r->convergence_count < 2) return true;
  double *room = calloc(3 * r->convergence_count, sizeof *room);
  if (room == NULL) return false;
  add_estimates(chart, v, room);
  free(room);
  return true;
}
