/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums and products of rationals. */

#include "solid_contacts/solid_section_parts.h"

void tp_rational3_init(fmpq v[3]) {
  for (int k = 0; k < 3; k++) fmpq_init(v + k);
}

void tp_rational3_clear(fmpq v[3]) {
  for (int k = 0; k < 3; k++) fmpq_clear(v + k);
}

void tp_rational3_set(fmpq v[3], const fmpq from[3]) {
  for (int k = 0; k < 3; k++) fmpq_set(v + k, from + k);
}

void tp_rational3_cross(fmpq product[3], const fmpq a[3], const fmpq b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpq_mul(product + k, a + i, b + j);
    fmpq_submul(product + k, a + j, b + i);
  }
}

void tp_rational3_dot(fmpq_t product, const fmpq a[3], const fmpq b[3]) {
  fmpq_mul(product, a, b);
  fmpq_addmul(product, a + 1, b + 1);
  fmpq_addmul(product, a + 2, b + 2);
}

int tp_rational3_sign(const fmpq a[3], const fmpq b[3]) {
  fmpq_t product;
  fmpq_init(product);
  tp_rational3_dot(product, a, b);
  const int sign = fmpq_sgn(product);
  fmpq_clear(product);
  return sign;
}

bool tp_rational3_is_zero(const fmpq v[3]) {
  return fmpq_is_zero(v) && fmpq_is_zero(v + 1) && fmpq_is_zero(v + 2);
}
