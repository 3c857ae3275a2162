/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The words in which a mend is told: parts of formulas, numbers, and which number is the simplest.
 */

#include "verify/mend.h"

#include "common/outside.h"
#include "number/ratio.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *tp_mend_part(char *out, size_t size, const tp_formula *formula, int begin, int end) {
  const char *text = formula->text + begin;
  static const char ellipsis[] = "…";
  const size_t length = (size_t)(end - begin);
  const bool fits = length < size;
  const size_t shown = tp_whole_characters(text, fits ? length : size - sizeof ellipsis);
  snprintf(out, size, "%.*s%s", (int)shown, text, fits ? "" : ellipsis);
  return out;
}

/* Whole numbers before halves, before thirds and so on; among those of one denominator the smaller
 * first. Sizes count up to MOST_SIZE, less than a step of the denominator. */
double tp_mend_simplicity(const fmpq_t value) {
  enum { OF_DENOMINATOR = 1000, MOST_SIZE = 900 };
  const double size = fabs(fmpq_get_d(value));
  return OF_DENOMINATOR * fmpz_get_d(fmpq_denref(value)) + fmin(size, MOST_SIZE);
}

void tp_mend_digits(char *out, size_t size, const fmpq_t value, bool decimal) {
  char *fraction = decimal ? NULL : fmpq_get_str(NULL, 10, value);
  if (fraction == NULL || strlen(fraction) >= size) {
    tp_ratio_text(out, size, value);
  } else {
    snprintf(out, size, "%s", fraction);
  }
  flint_free(fraction);
}

void tp_mend_number(char *out, size_t size, const fmpq_t value, bool decimal) {
  char text[80];
  tp_mend_digits(text, sizeof text, value, decimal);
  const bool plain = strchr(text, '/') == NULL && fmpq_sgn(value) >= 0;
  snprintf(out, size, plain ? "%s" : "(%s)", text);
}
