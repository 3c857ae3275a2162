/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ends are where powers pass zero (tilt_form.h). */

#include "case_filter/near_interval.h"

static void keep_up_to(tp_near_interval *own, tp_near end) {
  own->high = own->has_high ? tp_near_lesser(own->high, end) : end;
  own->has_high = true;
}

static void keep_from(tp_near_interval *own, tp_near end) {
  own->low = own->has_low ? tp_near_larger(own->low, end) : end;
  own->has_low = true;
}

/* Keep where rise t <= level, both times `sign`. False where open. */
static bool keep(tp_near_interval *own, tp_near rise, tp_near level, int sign) {
  if (tp_near_is_zero(rise)) {
    const int side = sign * tp_near_sign(level);
    own->empty = own->empty || side < 0;
    return side != 0;
  }
  const int side = sign * tp_near_sign(rise);
  if (side == 0) return false;
  const tp_near end = tp_near_div(level, rise);
  if (side > 0) {
    keep_up_to(own, end);
  } else {
    keep_from(own, end);
  }
  return true;
}

/* Likewise where the power of loads of which some stay with the block is below zero, times `sign`.
 */
static bool keep_below(tp_near_interval *own, const tp_tilt_form *power, int sign) {
  tp_tilt_change change;
  if (!tp_tilt_form_change(&change, power)) return false;
  if (change.level == change.upright) {
    own->empty = own->empty || sign * change.level > 0;
  } else if (sign * change.level < 0) {
    keep_up_to(own, change.tangent);
  } else {
    keep_from(own, change.tangent);
  }
  return true;
}

bool tp_near_interval_keep(tp_near_interval *own, const tp_tilt_form *power, int sign, bool stays) {
  return stays ? keep_below(own, power, sign)
               : keep(own, power->rise, tp_near_neg(power->level), sign);
}

void tp_near_interval_settle(tp_near_interval *own) {
  if (own->empty || !own->has_low || !own->has_high) return;
  const int order = tp_near_sign(tp_near_sub(own->high, own->low));
  own->empty = order < 0;
  own->perhaps = order == 0;
}

void tp_near_interval_unite(tp_near_interval *sum, const tp_near_interval *own) {
  if (own->empty) return;
  if (sum->empty) {
    *sum = *own;
    return;
  }
  sum->has_low = sum->has_low && own->has_low;
  sum->has_high = sum->has_high && own->has_high;
  if (sum->has_low) sum->low = tp_near_lesser(sum->low, own->low);
  if (sum->has_high) sum->high = tp_near_larger(sum->high, own->high);
}

/* An end that may be another one as well. */
static tp_near or_else(tp_near own, tp_near other) {
  const double low = fmin(own.value - own.error, other.value - other.error);
  const double high = fmax(own.value + own.error, other.value + other.error);
  const double value = low + (high - low) / 2;
  return tp_near_of(value, (high - low) / 2 + (fabs(value) + fabs(low) + fabs(high)) * DBL_EPSILON);
}

/* All of a mode: an interval, of which what may be in it or not is no more than an end. */
void tp_near_interval_add_perhaps(tp_near_interval *sum, const tp_near_interval *perhaps) {
  if (perhaps->empty) return;
  if (sum->empty) {
    *sum = *perhaps;
    return;
  }
  if (sum->has_low && tp_near_sign(tp_near_sub(perhaps->low, sum->low)) <= 0) {
    sum->low = or_else(sum->low, perhaps->low);
  }
  if (sum->has_high && tp_near_sign(tp_near_sub(sum->high, perhaps->high)) <= 0) {
    sum->high = or_else(sum->high, perhaps->high);
  }
}
