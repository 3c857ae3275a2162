/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sign of a ball, or zero where it is narrower than half the bits relative to the size of its
 * terms. */

#include "number/judge.h"

#include "number/ball.h"

int tp_judge_sign(const tp_judge *judge, const arb_t ball, double log2_scale) {
  if (arb_is_zero(ball)) return 0;
  if (arb_is_positive(ball)) return 1;
  if (arb_is_negative(ball)) return -1;
  if (!judge->settled || !arb_is_finite(ball)) return TP_OPEN_SIGN;
  const double width = tp_mag_log2_above(arb_radref(ball));
  const bool narrow = width < log2_scale - 0.5 * (double)judge->bits;
  return narrow && tp_judge_takes_equal(judge) ? 0 : TP_OPEN_SIGN;
}

bool tp_judge_takes_equal(const tp_judge *judge) {
  if (judge->settled && judge->took_zero != NULL) *judge->took_zero = true;
  return judge->settled;
}
