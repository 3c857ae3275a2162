/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rational of its own holds what is between, so that the result may be one of the arguments. */

#include "number/between.h"

double tp_ratio_apart(const fmpq_t one, const fmpq_t other) {
  fmpq_t difference;
  fmpq_init(difference);
  fmpq_sub(difference, one, other);
  const double result = fmpq_get_d(difference);
  fmpq_clear(difference);
  return result;
}

void tp_ratio_between(fmpq_t value, const fmpq_t from, const fmpq_t to, const fmpq_t share) {
  fmpq_t way;
  fmpq_init(way);
  fmpq_sub(way, to, from);
  fmpq_mul(way, way, share);
  fmpq_add(value, from, way);
  fmpq_clear(way);
}
