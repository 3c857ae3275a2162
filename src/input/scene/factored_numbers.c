/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers and arrays of a factored scene, which is a copy as it lies in memory, made its own. */

#include "scene/factored.h"

#include <stdlib.h>
#include <string.h>

void tp_factored_scale(fmpq_t value, const fmpq_t factor) {
  const fmpq held = *value;
  fmpq_init(value);
  fmpq_mul(value, &held, factor);
}

void tp_factored_scale_over(fmpq_t value, const fmpq_t divisor) {
  const fmpq held = *value;
  fmpq_init(value);
  fmpq_div(value, &held, divisor);
}

void *tp_factored_copy(const void *items, long count, size_t size) {
  void *copy = malloc((size_t)count * size + 1);
  if (copy != NULL && count > 0) memcpy(copy, items, (size_t)count * size);
  return copy;
}
