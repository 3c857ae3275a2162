/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Both ends of a ball printed by MPFR, and the longest text on which they agree; all texts belong
 * to one list. */

#include "number/decimals.h"

#include "common/grow.h"

#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

struct tp_decimals {
  int digits;
  long count, capacity;
  char **texts;
  bool failed;
};

tp_decimals *tp_decimals_new(int digits) {
  tp_decimals *decimals = calloc(1, sizeof *decimals);
  if (decimals != NULL) decimals->digits = digits;
  return decimals;
}

void tp_decimals_free(tp_decimals *decimals) {
  if (decimals == NULL) return;
  for (long k = 0; k < decimals->count; k++) free(decimals->texts[k]);
  free(decimals->texts);
  free(decimals);
}

bool tp_decimals_failed(const tp_decimals *decimals) {
  return decimals->failed;
}

static bool reserve(tp_decimals *decimals) {
  char **more = tp_grow(decimals->texts, decimals->count, &decimals->capacity, sizeof *more);
  if (more == NULL) return false;
  decimals->texts = more;
  return true;
}

static bool to_mpfr(mpfr_t number, const arf_t end) {
  const slong bits = arf_bits(end);
  mpfr_init2(number, bits > MPFR_PREC_MIN ? bits : MPFR_PREC_MIN);
  return arf_get_mpfr(number, end, MPFR_RNDN) == 0;
}

/* Both ends rounded to nearest, to the most digits that are the same. */
static bool write(char *text, char *other, size_t size, const mpfr_t low, const mpfr_t high,
                  int digits) {
  for (; digits > 0; digits--) {
    mpfr_snprintf(text, size, "%#.*Rg", digits, low);
    mpfr_snprintf(other, size, "%#.*Rg", digits, high);
    if (strcmp(text, other) == 0) return true;
  }
  return false;
}

/* Zeros after the point that an exact decimal does not need, and the point after them. */
static void shorten(char *text) {
  if (strchr(text, '.') == NULL) return;
  char *exponent = strchr(text, 'e');
  const size_t tail = exponent != NULL ? strlen(exponent) : 0;
  char *end = exponent != NULL ? exponent : text + strlen(text);
  char *last = end;
  while (last[-1] == '0') last--;
  if (last[-1] == '.') last--;
  memmove(last, end, tail + 1);
}

/* Is the exact number of `number` what the text says? */
static bool is_whole_truth(const char *text, const mpfr_t number) {
  mpfr_t back;
  mpfr_init2(back, mpfr_get_prec(number));
  const bool same = mpfr_set_str(back, text, 10, MPFR_RNDN) == 0 && mpfr_equal_p(back, number);
  mpfr_clear(back);
  return same;
}

/* Into `text` of `size` bytes; false where no digit is certain. */
static bool describe(char *text, char *other, size_t size, const arb_t ball, int digits) {
  arf_t ends[2];
  mpfr_t numbers[2];
  for (int k = 0; k < 2; k++) arf_init(ends[k]);
  arb_get_interval_arf(ends[0], ends[1], ball, ARF_PREC_EXACT);
  const bool exact = arb_is_exact(ball);
  bool done = to_mpfr(numbers[0], ends[0]);
  done = to_mpfr(numbers[1], ends[1]) && done;
  done = done && write(text, other, size, numbers[0], numbers[1], digits);
  if (done && exact && is_whole_truth(text, numbers[0])) shorten(text);
  for (int k = 0; k < 2; k++) {
    arf_clear(ends[k]);
    mpfr_clear(numbers[k]);
  }
  return done;
}

const char *tp_decimals_keep(tp_decimals *decimals, const arb_t ball) {
  if (!arb_is_finite(ball)) return NULL;
  const size_t size = (size_t)decimals->digits + 40; /* sign, point, zeros before, exponent */
  char *text = malloc(size), *other = malloc(size);
  const bool room = text != NULL && other != NULL && reserve(decimals);
  decimals->failed = decimals->failed || !room;
  const bool done = room && describe(text, other, size, ball, decimals->digits);
  free(other);
  if (!done) {
    free(text);
    return NULL;
  }
  decimals->texts[decimals->count++] = text;
  return text;
}
