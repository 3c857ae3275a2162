/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of loads that are linear in the tangent of the tilt, and their moments about a point, in
 * doubles with bounds (docs/mechanics.md section 5). */

#include "case_filter/filter_loads.h"

static const tp_near zero = {0, 0}, one = {1, 0};

/* W (-sin, -cos) on the block. */
void tp_filter_loads_init(tp_filter_loads *loads) {
  loads->called_for = loads->turns = false;
  loads->count = 1;
  loads->items[0] = (tp_filter_load){{zero, one, zero}, {one, zero, zero}};
  loads->sum = loads->items[0];
}

bool tp_filter_loads_add(tp_filter_loads *loads, const tp_filter_load *load) {
  if (loads->count == TP_FILTER_LOADS) return false;
  loads->items[loads->count++] = *load;
  for (int k = 0; k < 3; k++) {
    loads->sum.at[k] = tp_near_plus(loads->sum.at[k], load->at[k]);
    loads->sum.rise[k] = tp_near_plus(loads->sum.rise[k], load->rise[k]);
  }
  loads->turns = loads->turns || !tp_near_is_zero(load->at[2]) || !tp_near_is_zero(load->rise[2]);
  return true;
}

/* m - (x f_y - y f_x) */
static tp_near moment_about(const tp_near force[3], tp_near x, tp_near y) {
  const tp_near own = tp_near_minus(tp_near_times(x, force[1]), tp_near_times(y, force[0]));
  return tp_near_minus(force[2], own);
}

void tp_filter_load_arms(tp_near *level, tp_near *rise, const tp_filter_load *load, tp_near x,
                         tp_near y) {
  *level = moment_about(load->at, x, y);
  *rise = tp_near_neg(moment_about(load->rise, x, y));
}
