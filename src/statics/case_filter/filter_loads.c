/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of loads as functions of the tilt, and their moments about a point, in doubles with bounds
 * (docs/mechanics.md section 5). */

#include "case_filter/filter_loads.h"

static const tp_near zero = {0, 0}, one = {1, 0};

/* W (-sin, -cos) on the block. */
void tp_filter_loads_init(tp_filter_loads *loads) {
  loads->called_for = loads->turns = loads->stays = false;
  loads->count = 1;
  loads->items[0] = (tp_filter_load){.at = {zero, one, zero}, .rise = {one, zero, zero}};
  loads->sum = loads->items[0];
}

bool tp_filter_loads_add(tp_filter_loads *loads, const tp_filter_load *load) {
  if (loads->count == TP_FILTER_LOADS) return false;
  loads->items[loads->count++] = *load;
  for (int k = 0; k < 3; k++) {
    loads->sum.at[k] = tp_near_plus(loads->sum.at[k], load->at[k]);
    loads->sum.rise[k] = tp_near_plus(loads->sum.rise[k], load->rise[k]);
    loads->sum.fixed[k] = tp_near_plus(loads->sum.fixed[k], load->fixed[k]);
    loads->stays = loads->stays || !tp_near_is_zero(load->fixed[k]);
  }
  loads->turns = loads->turns || !tp_near_is_zero(load->at[2]) || !tp_near_is_zero(load->rise[2]) ||
                 !tp_near_is_zero(load->fixed[2]);
  return true;
}

/* m - (x f_y - y f_x) */
static tp_near moment_about(const tp_near force[3], tp_near x, tp_near y) {
  const tp_near own = tp_near_minus(tp_near_times(x, force[1]), tp_near_times(y, force[0]));
  return tp_near_minus(force[2], own);
}

void tp_filter_load_moment(tp_tilt_form *moment, const tp_filter_load *load, tp_near x, tp_near y) {
  moment->level = moment_about(load->at, x, y);
  moment->rise = moment_about(load->rise, x, y);
  moment->fixed = moment_about(load->fixed, x, y);
}

/* (cos, sin) = (t_2 s_1 - t_1 s_2, s_2 - s_1) / (t_2 - t_1), of tilts on one side of level without
 * that difference: over t_1 + t_2 it is 1 / (t_2 s_1 + t_1 s_2), 1 / (s_1 + s_2). */
void tp_filter_loads_apex(tp_near force[3], const tp_filter_loads *loads, tp_near low,
                          tp_near high) {
  const tp_near s_1 = tp_tilt_secant(low), s_2 = tp_tilt_secant(high);
  const tp_near t_2 = tp_near_times(high, s_1), t_1 = tp_near_times(low, s_2);
  tp_near cosine, sine;
  if (low.value < 0) {
    const tp_near apart = tp_near_sub(high, low);
    cosine = tp_near_div(tp_near_minus(t_2, t_1), apart);
    sine = tp_near_div(tp_near_sub(s_2, s_1), apart);
  } else {
    const tp_near both = tp_near_plus(low, high);
    cosine = tp_near_div(both, tp_near_plus(t_2, t_1));
    sine = tp_near_div(both, tp_near_add(s_1, s_2));
  }
  for (int k = 0; k < 3; k++) {
    const tp_near turned = tp_near_plus(tp_near_times(cosine, loads->sum.at[k]),
                                        tp_near_times(sine, loads->sum.rise[k]));
    force[k] = tp_near_plus(turned, loads->sum.fixed[k]);
  }
}
