/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Expressions in named parameters. */

#include "fuzz.h"
#include "number/ratio.h"
#include "scene/expression.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char a[] = "a", b[] = "b", zero[] = "zero", *names[] = {a, b, zero};
  fmpq values[3];
  for (int k = 0; k < 3; k++) fmpq_init(values + k);
  fmpq_set_si(values, 3, 10);
  fmpq_set_si(values + 1, -7, 1);
  const tp_parameters parameters = {3, names, values};
  char *text = fuzz_text(data, size);
  fmpq_t value;
  tp_message message = {.text = ""};
  fmpq_init(value);
  fmpq_set_si(value, 41, 43);
  const tp_status status =
      tp_expression_evaluate(value, text, (tp_place){"text", 1, 1}, &parameters, &message);
  fmpq_set_si(values, 41, 43);
  if (status == TP_OK) {
    FUZZ_EXPECT(fmpq_is_canonical(value));
    FUZZ_EXPECT(!tp_ratio_is_not_finite(text));
  } else {
    FUZZ_EXPECT(message.text[0] != '\0' && fmpq_equal(value, values));
  }
  fmpq_clear(value);
  for (int k = 0; k < 3; k++) fmpq_clear(values + k);
  free(text);
  return 0;
}
