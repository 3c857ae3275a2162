/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Labels at 1, 2, 5 or at seven places of each decade within the range, as a gnuplot list of
 * tics. */

#include "chart/log_ticks.h"

#include <math.h>

void tp_script_log_ticks(tp_text *t, const tp_panel_axis *axis, char name) {
  static const double few[] = {1, 2, 5}, more[] = {1, 1.5, 2, 3, 4, 5, 7};
  const double from = axis->range.from, to = axis->range.to;
  const bool is_short = to < 6 * from;
  const size_t count = is_short ? sizeof more / sizeof *more : sizeof few / sizeof *few;
  const char *before = "";
  tp_text_add(t, "set %ctics (", name);
  for (int decade = (int)floor(log10(from)); pow(10, decade) <= to; decade++) {
    for (size_t k = 0; k < count; k++) {
      const double at = (is_short ? more : few)[k] * pow(10, decade);
      if (at < from || at > to) continue;
      tp_text_add(t, "%s%.6g", before, at);
      before = ", ";
    }
  }
  tp_text_add(t, ")\n");
}
