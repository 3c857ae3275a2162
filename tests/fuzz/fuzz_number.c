/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers: decimals and fractions of them, read as a field and from the front of a text. */

#include "fuzz.h"
#include "number/ratio.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = fuzz_text(data, size), printed[64];
  const char *problem = NULL;
  fmpq_t value, again;
  fmpq_init(value);
  fmpq_init(again);
  if (tp_ratio_read_fraction(value, text, size, &problem)) {
    FUZZ_EXPECT(fmpq_is_canonical(value));
    tp_ratio_text(printed, sizeof printed, value);
    FUZZ_EXPECT(printed[0] != '\0' && strlen(printed) < sizeof printed - 1);
    /* as long as all its digits fit, what is printed is the value, or names the same double */
    const bool exact = fmpz_bits(fmpq_numref(value)) <= 60 && fmpz_bits(fmpq_denref(value)) <= 60;
    FUZZ_EXPECT(!exact ||
                (tp_ratio_read_fraction(again, printed, strlen(printed), &problem) &&
                 (fmpq_equal(value, again) || strtod(printed, NULL) == fmpq_get_d(value))));
  } else {
    FUZZ_EXPECT(problem != NULL);
  }
  problem = NULL;
  const size_t used = tp_ratio_read_decimal(value, text, size, &problem);
  FUZZ_EXPECT(used <= size && (used > 0) == (problem == NULL));
  if (used > 0) FUZZ_EXPECT(fmpq_is_canonical(value) && fmpq_sgn(value) >= 0);
  fmpq_clear(value);
  fmpq_clear(again);
  free(text);
  return 0;
}
