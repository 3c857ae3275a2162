/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The divisor is looked at before FLINT is called. */

#include "number/divide.h"

bool tp_divide(fmpq_t quotient, const fmpq_t a, const fmpq_t b) {
  if (fmpq_is_zero(b)) return false;
  fmpq_div(quotient, a, b);
  return true;
}

tp_status tp_divide_above_zero(fmpq_t quotient, const fmpq_t a, const fmpq_t b, tp_place place,
                               const char *what, tp_message *message) {
  if (fmpq_sgn(b) > 0 && tp_divide(quotient, a, b)) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place, "%s", what);
}
