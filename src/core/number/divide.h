/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Quotients of rationals whose divisor may be zero. FLINT ends the process where it divides by
 * zero.
 *
 * A divisor that follows from a number of the input by rounding can be zero where that number is
 * not: a direction is a fraction within 1e-8 degrees of its angle, so that the sine of 1e-12
 * degrees is zero. Every such quotient goes through one of these calls. tests/data/divisions.csv
 * lists all other divisions of rationals, with the reason why the divisor of each cannot be zero.
 */

#ifndef TP_NUMBER_DIVIDE_H
#define TP_NUMBER_DIVIDE_H

#include "common/message.h"

#include <flint/fmpq.h>

/* quotient = a / b; false where b is zero, and the quotient is what it was. */
TP_MUST_USE bool tp_divide(fmpq_t quotient, const fmpq_t a, const fmpq_t b);

/* The same, for b above zero: where it is not, bad input at the place; `what` says what is wrong
 * with the number there. */
TP_MUST_USE tp_status tp_divide_above_zero(fmpq_t quotient, const fmpq_t a, const fmpq_t b,
                                           tp_place place, const char *what, tp_message *message);

#endif
