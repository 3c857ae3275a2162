/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Verdicts on printed numbers.
 *
 * With d printed decimals and m the printed number times 10^d, a whole number, the printed digits
 * are the rounding of x if |10^d x - m| <= 1/2, and its truncation if 10^d x lies between m and the
 * next whole number away from zero. The computed value is enclosed, and enclosed more tightly until
 * this is decided. A relation, as in `< 0.1`, is decided in the same way. */

#include "verify/decide.h"

#include "number/ball.h"
#include "number/ratio.h"

#include <ctype.h>
#include <string.h>

enum { FIRST_BITS = 128, MOST_BITS = 8192 };

/* A printed number: relation ('=' none, '<', '>', 'l' <=, 'g' >=), value, and its decimals. */
typedef struct printed_number {
  char relation;
  fmpq_t value;
  long decimals;
} printed_number;

static const char *skip(const char *text) {
  while (*text == ' ') text++;
  return text;
}

static bool read_printed(printed_number *p, const char *text, const char **problem) {
  text = skip(text);
  p->relation = *text == '<' || *text == '>' ? *text++ : '=';
  if (p->relation != '=' && *text == '=') {
    p->relation = p->relation == '<' ? 'l' : 'g';
    text++;
  }
  text = skip(text);
  bool negative = *text == '-';
  if (*text == '-' || *text == '+') {
    text = skip(text + 1);
  } else if (strncmp(text, "\u2212", 3) == 0) {
    negative = true;
    text = skip(text + 3);
  }
  const size_t used = tp_ratio_read_decimal(p->value, text, strlen(text), problem);
  if (used == 0 || *skip(text + used) != '\0') return false;
  if (negative) fmpq_neg(p->value, p->value);
  p->decimals = 0;
  const char *point = memchr(text, '.', used);
  for (const char *c = point != NULL ? point + 1 : text;
       point != NULL && isdigit((unsigned char)*c); c++) {
    p->decimals++;
  }
  const char *e = strpbrk(text, "eE");
  if (e != NULL) p->decimals -= strtol(e + 1, NULL, 10);
  return true;
}

bool tp_decide_is_number(const char *text) {
  printed_number p;
  const char *problem = NULL;
  fmpq_init(p.value);
  const bool number = read_printed(&p, text, &problem);
  fmpq_clear(p.value);
  return number;
}

/* -1, 0 or 1 as the ball is known to lie below, or above, the rational; 0: not known. */
static int side_of(const arb_t x, const fmpq_t bound, long bits) {
  arb_t gap;
  arb_init(gap);
  arb_set_fmpq(gap, bound, bits);
  arb_sub(gap, x, gap, bits);
  const int side = arb_is_positive(gap) ? 1 : arb_is_negative(gap) ? -1 : 0;
  arb_clear(gap);
  return side;
}

/* Does x lie in [low, high]: 1 yes, -1 no, 0 not known. A ball within rounding of an end that is a
 * value of x itself is not told apart from it. */
static int within(const arb_t x, const fmpq_t low, const fmpq_t high, long bits) {
  const int left = side_of(x, low, bits), right = side_of(x, high, bits);
  if (left < 0 || right > 0) return -1;
  return left > 0 && right < 0 ? 1 : 0;
}

/* 10^decimals x against m. */
static bool decide_digits(tp_verdict *verdict, const arb_t x, const printed_number *p, long bits) {
  arb_t scaled;
  fmpq_t m, low, high, half;
  arb_init(scaled);
  fmpq_init(m);
  fmpq_init(low);
  fmpq_init(high);
  fmpq_init(half);
  fmpz_t power;
  fmpz_init(power);
  fmpz_ui_pow_ui(power, 10, (ulong)(p->decimals < 0 ? -p->decimals : p->decimals));
  if (p->decimals < 0) {
    fmpq_div_fmpz(m, p->value, power);
    arb_div_fmpz(scaled, x, power, bits);
  } else {
    fmpq_mul_fmpz(m, p->value, power);
    arb_mul_fmpz(scaled, x, power, bits);
  }
  fmpq_set_si(half, 1, 2);
  fmpq_sub(low, m, half);
  fmpq_add(high, m, half);
  const int rounds = within(scaled, low, high, bits);
  fmpq_set(low, m);
  fmpq_set(high, m);
  fmpq_set_si(half, 1, 1);
  if (fmpq_sgn(m) >= 0) fmpq_add(high, m, half);
  if (fmpq_sgn(m) <= 0) fmpq_sub(low, m, half);
  const int cuts = within(scaled, low, high, bits);
  *verdict = rounds > 0 ? TP_VERDICT_AGREES
             : cuts > 0 ? TP_VERDICT_TRUNCATED
                        : TP_VERDICT_DISAGREES;
  fmpz_clear(power);
  fmpq_clear(m);
  fmpq_clear(low);
  fmpq_clear(high);
  fmpq_clear(half);
  arb_clear(scaled);
  return rounds > 0 || (rounds < 0 && cuts != 0);
}

static bool decide_once(tp_verdict *verdict, const arb_t x, const printed_number *p, long bits) {
  if (p->relation == '=') return decide_digits(verdict, x, p, bits);
  const int side = side_of(x, p->value, bits);
  const bool below = p->relation == '<' || p->relation == 'l';
  *verdict = (side < 0) == below ? TP_VERDICT_AGREES : TP_VERDICT_DISAGREES;
  return side != 0;
}

tp_status tp_decide_number(tp_claim_result *result, const tp_question *q) {
  printed_number p;
  const char *problem = NULL;
  fmpq_init(p.value);
  if (!read_printed(&p, q->number, &problem)) {
    fmpq_clear(p.value);
    return tp_fail(q->message, TP_BAD_INPUT, q->number_place, "'%.40s' %s", q->number, problem);
  }
  arb_t x;
  arb_init(x);
  tp_status status = TP_OK;
  bool decided = false;
  for (long bits = FIRST_BITS; bits <= MOST_BITS && status == TP_OK && !decided; bits *= 2) {
    status = tp_evaluate_ball(x, q->quantity, q->subject, q->sample, true, bits, q->message);
    if (status == TP_OK && !arb_is_finite(x)) {
      if (bits < MOST_BITS) continue;
      status = tp_formula_fail(q->quantity, tp_formula_root(q->quantity), q->message,
                               "this has no finite value at the claim's values");
    }
    if (status == TP_OK) decided = decide_once(&result->verdict, x, &p, bits);
  }
  if (status == TP_OK) {
    if (!decided) result->verdict = TP_VERDICT_UNDECIDED;
    result->has_values = true;
    result->computed = tp_ball_bounded(x);
    arb_set_fmpq(x, p.value, FIRST_BITS);
    result->printed_value = tp_ball_bounded(x);
  }
  arb_clear(x);
  fmpq_clear(p.value);
  return status;
}
