/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A load as rational numbers, and its doubles. */

#include "solid_contacts/hold_load.h"

#include <math.h>

void tp_hold_double(fmpq_t number, double value) {
  int exponent;
  const double mantissa = ldexp(frexp(value, &exponent), DBL_MANT_DIG);
  /* not by way of a whole number of the machine, which may have 32 bits */
  fmpz_set_d(fmpq_numref(number), mantissa);
  fmpz_one(fmpq_denref(number));
  if (exponent >= DBL_MANT_DIG) {
    fmpq_mul_2exp(number, number, (ulong)(exponent - DBL_MANT_DIG));
  } else {
    fmpq_div_2exp(number, number, (ulong)(DBL_MANT_DIG - exponent));
  }
}

void tp_hold_load_init(tp_hold_load *load) {
  *load = (tp_hold_load){.nearest = {0}};
  for (int k = 0; k < 3; k++) fmpq_init(load->exact + k);
}

void tp_hold_load_settle(tp_hold_load *load) {
  for (int k = 0; k < 3; k++) {
    const double value = load->nearest[k] = fmpq_get_d(load->exact + k);
    load->near[k] = fmpq_is_zero(load->exact + k) ? (tp_near){0, 0}
                                                  : tp_near_of(value, fabs(value) * DBL_EPSILON);
  }
}

void tp_hold_load_clear(tp_hold_load *load) {
  for (int k = 0; k < 3; k++) fmpq_clear(load->exact + k);
}

tp_near tp_hold_gain(const double twist[TP_WRENCH], const tp_hold_load *load) {
  tp_near sum = {0, 0};
  for (int k = 0; k < 3; k++) {
    sum = tp_near_plus(sum, tp_near_times((tp_near){twist[k], 0}, load->near[k]));
  }
  return sum;
}
