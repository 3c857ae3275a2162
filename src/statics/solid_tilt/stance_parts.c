/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least of quantities with bounds, roots of quadratics, and vectors along the dip. */

#include "solid_tilt/stance_parts.h"

bool tp_least_take(tp_least *l, tp_near value, tp_mechanism mechanism) {
  const bool lower = !l->found || value.value < l->smallest.value;
  const bool open = l->found && tp_near_sign(tp_near_sub(value, l->smallest)) == 0;
  l->value = l->found ? tp_near_lesser(l->value, value) : value;
  if (open && l->mechanism != mechanism) {
    l->mechanism = TP_MECHANISM_UNDECIDED;
  } else if (lower) {
    l->mechanism = mechanism;
  }
  if (lower) l->smallest = value;
  l->found = true;
  return lower;
}

bool tp_least_root(tp_near *root, tp_near a, tp_near b, tp_near c) {
  const tp_near square = tp_near_minus(tp_near_times(b, b), tp_near_times(a, c));
  *root = c;
  if (tp_near_is_zero(c)) return true;
  if (tp_near_sign(square) < 0) return false;
  const tp_near part = tp_near_is_zero(square) ? square : tp_near_sqrt(square);
  const tp_near bottom = tp_near_plus(b, part);
  if (tp_near_sign(bottom) < 0 || tp_near_is_zero(bottom)) return false;
  *root = tp_near_sign(bottom) > 0 ? tp_near_div(tp_near_neg(c), bottom) : (tp_near){0, INFINITY};
  return true;
}

void tp_stance_turn(tp_near *along, tp_near *across, const tp_stance *x, tp_near east,
                    tp_near north) {
  *along = tp_near_plus(tp_near_times(east, x->down[0]), tp_near_times(north, x->down[1]));
  *across = tp_near_minus(tp_near_times(east, x->down[1]), tp_near_times(north, x->down[0]));
}
