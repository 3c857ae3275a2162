/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Verdicts on printed numbers.
 *
 * The printed digits are the rounding of x if x lies within half a unit of the last of them, and
 * its truncation if it lies between them and the next number away from zero with as many decimals.
 * The computed value is enclosed, and enclosed more tightly until this is decided. A relation, as
 * in
 * `< 0.1`, is decided in the same way. */

#include "verify/decide.h"

#include "common/outside.h"
#include "derive/field_work.h"
#include "number/ball.h"
#include "number/ratio.h"
#include "verify/evaluate.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Doubled until the digits printed are told, or what is printed is taken for undecided. */
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
  p->relation = '=';
  if (*text == '<' || *text == '>') p->relation = *text++;
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
  const int side = tp_ball_sign(gap);
  arb_clear(gap);
  return side;
}

/* Does x lie in [low, high]: 1 yes, -1 no, 0 not known? */
static int within(const arb_t x, const fmpq_t low, const fmpq_t high, long bits) {
  const int left = side_of(x, low, bits), right = side_of(x, high, bits);
  if (left < 0 || right > 0) return -1;
  return left > 0 && right < 0 ? 1 : 0;
}

/* The numbers whose rounding, or truncation, to its decimals the printed number is. */
static void set_intervals(fmpq_t least, fmpq_t most, fmpq_t inner, fmpq_t outer,
                          const printed_number *p) {
  fmpq_t unit, half;
  fmpz_t power;
  fmpq_init(unit);
  fmpq_init(half);
  fmpz_init(power);
  fmpz_ui_pow_ui(power, 10, (ulong)labs(p->decimals));
  fmpq_one(unit);
  if (p->decimals < 0) {
    fmpq_mul_fmpz(unit, unit, power);
  } else {
    fmpq_div_fmpz(unit, unit, power);
  }
  fmpq_div_2exp(half, unit, 1);
  fmpq_sub(least, p->value, half);
  fmpq_add(most, p->value, half);
  fmpq_set(inner, p->value);
  fmpq_set(outer, p->value);
  if (fmpq_sgn(p->value) >= 0) fmpq_add(outer, outer, unit);
  if (fmpq_sgn(p->value) <= 0) fmpq_sub(inner, inner, unit);
  fmpq_clear(unit);
  fmpq_clear(half);
  fmpz_clear(power);
}

static bool decide_digits(tp_verdict *verdict, const arb_t x, const printed_number *p, long bits) {
  fmpq_t least, most, inner, outer;
  fmpq_init(least);
  fmpq_init(most);
  fmpq_init(inner);
  fmpq_init(outer);
  set_intervals(least, most, inner, outer, p);
  const int rounds = within(x, least, most, bits), cuts = within(x, inner, outer, bits);
  *verdict = rounds > 0 ? TP_VERDICT_AGREES
             : cuts > 0 ? TP_VERDICT_TRUNCATED
                        : TP_VERDICT_DISAGREES;
  fmpq_clear(least);
  fmpq_clear(most);
  fmpq_clear(inner);
  fmpq_clear(outer);
  return rounds > 0 || (rounds < 0 && cuts != 0);
}

static bool is_below(const printed_number *p) {
  return p->relation == '<' || p->relation == 'l';
}

static bool decide_once(tp_verdict *verdict, const arb_t x, const printed_number *p, long bits) {
  if (p->relation == '=') return decide_digits(verdict, x, p, bits);
  const int side = side_of(x, p->value, bits);
  *verdict = (side < 0) == is_below(p) ? TP_VERDICT_AGREES : TP_VERDICT_DISAGREES;
  return side != 0;
}

/* Does the quantity take a rational value at the sample, without sines and cosines? */
static tp_status exact_value(fmpq_t x, bool *exact, const tp_question *q) {
  const tp_subject *s = q->subject;
  int *used = calloc((size_t)s->field->symbol_count, sizeof *used);
  if (used == NULL) return tp_fail_memory(q->message, "a number");
  fmpz_mpoly_q_t formula;
  fmpz_mpoly_q_init(formula, s->field->ring);
  tp_branches here;
  tp_branches_init(&here, q->subject, q->sample);
  here.only_sample = true;
  tp_branches_use(&here, q->subject);
  const tp_status status = tp_evaluate_field(formula, exact, q->quantity, q->subject, q->message);
  tp_branches_use(NULL, q->subject);
  tp_branches_clear(&here);
  if (status == TP_OK && *exact) {
    fmpz_mpoly_q_used_vars(used, formula, s->field->ring);
    for (long k = 0; k < s->angle_count; k++) {
      if (used[s->angles[k].sine] || used[s->angles[k].cosine]) *exact = false;
    }
    if (used[s->angles[TP_ANGLE_I].degrees]) *exact = false;
    *exact = *exact && tp_field_evaluate_at(x, formula, q->sample->values, s->field);
  }
  free(used);
  fmpz_mpoly_q_clear(formula, s->field->ring);
  return status;
}

/* What no enclosure tells apart: a rational value that is exactly half-way, or the bound of a
 * relation. Half-way is the rounding of both its neighbours. */
static tp_status decide_tie(tp_verdict *verdict, const printed_number *p, const tp_question *q) {
  fmpq_t x;
  bool exact = false;
  fmpq_init(x);
  const tp_status status = exact_value(x, &exact, q);
  *verdict = TP_VERDICT_UNDECIDED;
  if (status == TP_OK && exact && p->relation == '=') {
    fmpq_t least, most, inner, outer;
    fmpq_init(least);
    fmpq_init(most);
    fmpq_init(inner);
    fmpq_init(outer);
    set_intervals(least, most, inner, outer, p);
    const bool rounds = fmpq_cmp(x, least) >= 0 && fmpq_cmp(x, most) <= 0;
    *verdict = rounds ? TP_VERDICT_AGREES : TP_VERDICT_DISAGREES;
    fmpq_clear(least);
    fmpq_clear(most);
    fmpq_clear(inner);
    fmpq_clear(outer);
  } else if (status == TP_OK && exact) {
    const bool equal = p->relation == 'l' || p->relation == 'g';
    *verdict = equal ? TP_VERDICT_AGREES : TP_VERDICT_DISAGREES;
  }
  fmpq_clear(x);
  return status;
}

tp_status tp_decide_number(tp_claim_result *result, const tp_question *q) {
  printed_number p;
  const char *problem = NULL;
  fmpq_init(p.value);
  if (!read_printed(&p, q->number, &problem)) {
    fmpq_clear(p.value);
    return tp_refuse(q->message, TP_FAULT_KEY, q->number_place, "'%s' %s",
                     tp_quote_all(q->number).text, problem);
  }
  arb_t x;
  arb_init(x);
  tp_status status = TP_OK;
  bool decided = false;
  const tp_field_work *work = q->subject->field->work;
  for (long bits = FIRST_BITS; bits <= MOST_BITS && status == TP_OK && !decided; bits *= 2) {
    const double units = tp_evaluate_units(q->quantity, q->subject, bits);
    if (bits > FIRST_BITS && work->spent + units > work->budget / 2) break; /* undecided */
    (void)tp_field_spend(q->subject->field, units);
    status = tp_evaluate_ball(x, q->quantity, q->subject, q->sample, true, bits, q->message);
    if (status == TP_OK && !arb_is_finite(x)) {
      if (bits < MOST_BITS) continue;
      status = tp_formula_fail(q->quantity, tp_formula_root(q->quantity), q->message,
                               "this has no finite value at the claim's values");
    }
    if (status == TP_OK) decided = decide_once(&result->verdict, x, &p, bits);
  }
  if (status == TP_OK) {
    if (!decided) status = decide_tie(&result->verdict, &p, q);
    result->has_values = true;
    result->computed_there = tp_ball_bounded(x);
    arb_set_fmpq(x, p.value, FIRST_BITS);
    result->printed_there = tp_ball_bounded(x);
  }
  arb_clear(x);
  fmpq_clear(p.value);
  return status;
}
