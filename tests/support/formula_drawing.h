/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random formulas as texts, evaluated while they are written. */

#ifndef TP_TEST_FORMULA_DRAWING_H
#define TP_TEST_FORMULA_DRAWING_H

#include "random_numbers.h"

#include <gmp.h>
#include <stdbool.h>

enum { SIZE = 4000, FIRST_NAMES = 4 };

/* Names and their values: a fraction, a decimal, a negative number, an angle in degrees. */
extern const char *const names[FIRST_NAMES];
extern const long tops[FIRST_NAMES], belows[FIRST_NAMES];

/* How a text binds: a sum, a product, a sign, a power, a thing of its own. */
typedef enum binding { SUM, PRODUCT, SIGN, POWER, ATOM } binding;

typedef struct written {
  char text[SIZE];
  binding binds;
  mpq_t exact; /* where no functions are asked for */
  double value;
} written;

void written_init(written *w);
/* Draw until a formula fits. */
void draw_formula(written *w, random_numbers *random, bool functions);

#endif
