/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The field of formulas against rationals: a random chain of operations on rational functions is
 * done to numbers at the same time, at four random points. What it comes to is in lowest terms, and
 * has the numbers' values; equal functions that were come to in other ways are the same formula. */

#include "derive/field.h"
#include "random_numbers.h"
#include "suite.h"

#include <flint/fmpq_vec.h>
#include <string.h>

enum { SYMBOLS = 3, POINTS = 4, STEPS = 7, ROUNDS = 1500, BITS = 200 };

static random_numbers state;

static const char *const names[SYMBOLS] = {"a", "b", "c"};

/* Values of the field's symbols: the caller's are the last, the others do not occur. */
typedef struct points {
  long count; /* of symbols */
  fmpq *at[POINTS];
} points;

static void points_init(points *p, const tp_field *field) {
  p->count = field->symbol_count;
  for (int k = 0; k < POINTS; k++) {
    p->at[k] = _fmpq_vec_init(p->count);
    for (long s = 0; s < p->count; s++) {
      fmpq_set_si(p->at[k] + s, draw_below(&state, 41) - 20, 1 + (ulong)draw_below(&state, 9));
    }
  }
}

static void points_clear(points *p) {
  for (int k = 0; k < POINTS; k++) _fmpq_vec_clear(p->at[k], p->count);
}

/* A formula, and its values at the points where it has some. */
typedef struct valued {
  fmpz_mpoly_q_t formula;
  fmpq value[POINTS];
  bool defined[POINTS];
} valued;

static void valued_init(valued *f, const tp_field *field) {
  fmpz_mpoly_q_init(f->formula, field->ring);
  for (int k = 0; k < POINTS; k++) fmpq_init(f->value + k);
}

static void valued_clear(valued *f, const tp_field *field) {
  fmpz_mpoly_q_clear(f->formula, field->ring);
  for (int k = 0; k < POINTS; k++) fmpq_clear(f->value + k);
}

/* A symbol, or a number. */
static void set_leaf(valued *f, const tp_field *field, const points *p) {
  const long which = draw_below(&state, SYMBOLS + 1);
  if (which == SYMBOLS) {
    fmpq_t number;
    fmpq_init(number);
    fmpq_set_si(number, draw_below(&state, 13) - 6, 1 + (ulong)draw_below(&state, 4));
    fmpz_mpoly_q_set_fmpq(f->formula, number, field->ring);
    for (int k = 0; k < POINTS; k++) fmpq_set(f->value + k, number);
    fmpq_clear(number);
  } else {
    const long symbol = tp_field_added(field, which);
    fmpz_mpoly_q_gen(f->formula, symbol, field->ring);
    for (int k = 0; k < POINTS; k++) fmpq_set(f->value + k, p->at[k] + symbol);
  }
  for (int k = 0; k < POINTS; k++) f->defined[k] = true;
}

/* f = f op g. False, with f as it was, for a division by zero. */
static bool operate(valued *f, const valued *g, char op, const tp_field *field) {
  if (op == '/' && fmpz_mpoly_q_is_zero(g->formula, field->ring)) return false;
  void (*const own)(fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const tp_field *) =
      op == '+'   ? tp_field_add
      : op == '-' ? tp_field_sub
      : op == '*' ? tp_field_mul
                  : tp_field_div;
  own(f->formula, f->formula, g->formula, field);
  for (int k = 0; k < POINTS; k++) {
    f->defined[k] = f->defined[k] && g->defined[k] && !(op == '/' && fmpq_is_zero(g->value + k));
    if (!f->defined[k]) continue;
    if (op == '+') fmpq_add(f->value + k, f->value + k, g->value + k);
    if (op == '-') fmpq_sub(f->value + k, f->value + k, g->value + k);
    if (op == '*') fmpq_mul(f->value + k, f->value + k, g->value + k);
    if (op == '/') fmpq_div(f->value + k, f->value + k, g->value + k);
  }
  return true;
}

static void build(valued *f, const tp_field *field, const points *p) {
  set_leaf(f, field, p);
  for (int step = 0; step < STEPS; step++) {
    valued leaf, other;
    valued_init(&leaf, field);
    valued_init(&other, field);
    set_leaf(&leaf, field, p);
    set_leaf(&other, field, p);
    (void)operate(&leaf, &other, "+-*/"[draw_below(&state, 4)], field);
    (void)operate(f, &leaf, "+-*/"[draw_below(&state, 4)], field);
    valued_clear(&leaf, field);
    valued_clear(&other, field);
  }
}

/* Nothing divides both, the denominator's first coefficient is above zero, and zero is 0 / 1. */
static void check_lowest_terms(const fmpz_mpoly_q_t f, const tp_field *field) {
  const fmpz_mpoly_struct *above = fmpz_mpoly_q_numref(f), *below = fmpz_mpoly_q_denref(f);
  fmpz_mpoly_t common;
  fmpz_mpoly_init(common, field->ring);
  ck_assert(fmpz_mpoly_gcd(common, above, below, field->ring) != 0);
  ck_assert(fmpz_mpoly_is_one(common, field->ring));
  ck_assert_int_gt(fmpz_sgn(below->coeffs), 0);
  fmpz_mpoly_clear(common, field->ring);
}

/* Returns at how many points. A value may be there where a step on the way had none. */
static long check_values(const valued *f, const tp_field *field, const points *p) {
  long count = 0;
  fmpq_t value;
  arb_t ball;
  fmpq_init(value);
  arb_init(ball);
  for (int k = 0; k < POINTS; k++) {
    if (!f->defined[k]) continue;
    count++;
    ck_assert(tp_field_evaluate_at(value, f->formula, p->at[k], field));
    ck_assert(fmpq_equal(value, f->value + k));
    arb_ptr symbols = _arb_vec_init(p->count);
    for (long s = 0; s < p->count; s++) arb_set_fmpq(symbols + s, p->at[k] + s, BITS);
    tp_field_evaluate_ball(ball, f->formula, symbols, field, BITS);
    ck_assert(arb_contains_fmpq(ball, f->value + k));
    _arb_vec_clear(symbols, p->count);
  }
  fmpq_clear(value);
  arb_clear(ball);
  return count;
}

static void field_init(tp_field *field) {
  tp_message message = {.text = ""};
  const tp_symbol_names more = {SYMBOLS, names};
  ck_assert_int_eq(tp_field_init(field, NULL, &more, &message), TP_OK);
}

START_TEST(formulas_have_the_values_of_their_numbers) {
  state = random_numbers_from(91);
  tp_field field;
  points p;
  long count = 0, fractions = 0;
  field_init(&field);
  points_init(&p, &field);
  for (int round = 0; round < ROUNDS; round++) {
    valued f;
    field.work->spent = 0;
    valued_init(&f, &field);
    build(&f, &field, &p);
    ck_assert_ptr_null(tp_field_problem(&field));
    check_lowest_terms(f.formula, &field);
    count += check_values(&f, &field, &p);
    fractions += !fmpz_mpoly_is_fmpz(fmpz_mpoly_q_denref(f.formula), field.ring);
    valued_clear(&f, &field);
  }
  ck_assert_int_gt(count, ROUNDS * POINTS / 2);
  ck_assert_int_gt(fractions, ROUNDS / 2);
  points_clear(&p);
  tp_field_clear(&field);
}
END_TEST

/* (f + g) - g = f, (f g) / g = f, (f + g) (f - g) = f^2 - g^2, f^3 = f f f, f^-2 f^2 = 1: the same
 * numerator and denominator, term by term. */
static void check_identities(const valued *f, const valued *g, const tp_field *field) {
  fmpz_mpoly_q_t one, other, third;
  fmpz_mpoly_q_init(one, field->ring);
  fmpz_mpoly_q_init(other, field->ring);
  fmpz_mpoly_q_init(third, field->ring);
  tp_field_add(one, f->formula, g->formula, field);
  tp_field_sub(other, one, g->formula, field);
  ck_assert(fmpz_mpoly_q_equal(other, f->formula, field->ring));
  tp_field_sub(other, f->formula, g->formula, field);
  tp_field_mul(one, one, other, field);
  fmpz_mpoly_q_set(other, f->formula, field->ring);
  fmpz_mpoly_q_set(third, g->formula, field->ring);
  ck_assert_ptr_null(tp_field_power(other, 2, field));
  ck_assert_ptr_null(tp_field_power(third, 2, field));
  tp_field_sub(third, other, third, field);
  ck_assert(fmpz_mpoly_q_equal(one, third, field->ring));
  fmpz_mpoly_q_set(one, f->formula, field->ring);
  ck_assert_ptr_null(tp_field_power(one, 3, field));
  tp_field_mul(other, other, f->formula, field);
  ck_assert(fmpz_mpoly_q_equal(one, other, field->ring));
  if (!fmpz_mpoly_q_is_zero(g->formula, field->ring)) {
    tp_field_mul(one, f->formula, g->formula, field);
    tp_field_div(one, one, g->formula, field);
    ck_assert(fmpz_mpoly_q_equal(one, f->formula, field->ring));
    fmpz_mpoly_q_set(one, g->formula, field->ring);
    fmpz_mpoly_q_set(other, g->formula, field->ring);
    ck_assert_ptr_null(tp_field_power(one, -2, field));
    ck_assert_ptr_null(tp_field_power(other, 2, field));
    tp_field_mul(one, one, other, field);
    ck_assert(fmpz_mpoly_q_is_one(one, field->ring));
  }
  fmpz_mpoly_q_clear(one, field->ring);
  fmpz_mpoly_q_clear(other, field->ring);
  fmpz_mpoly_q_clear(third, field->ring);
}

START_TEST(equal_formulas_are_the_same) {
  state = random_numbers_from(92);
  tp_field field;
  points p;
  field_init(&field);
  points_init(&p, &field);
  for (int round = 0; round < ROUNDS / 3; round++) {
    valued f, g;
    field.work->spent = 0;
    valued_init(&f, &field);
    valued_init(&g, &field);
    build(&f, &field, &p);
    build(&g, &field, &p);
    check_identities(&f, &g, &field);
    ck_assert_ptr_null(tp_field_problem(&field));
    valued_clear(&f, &field);
    valued_clear(&g, &field);
  }
  points_clear(&p);
  tp_field_clear(&field);
}
END_TEST

/* What would be too large, or cost too much, is not done: its value is zero, and so are all that
 * follow, until it is forgiven; a spent budget is not. Zero has no powers below it. */
START_TEST(work_has_an_end) {
  tp_field field;
  fmpz_mpoly_q_t f, symbol;
  field_init(&field);
  fmpz_mpoly_q_init(f, field.ring);
  fmpz_mpoly_q_init(symbol, field.ring);
  fmpz_mpoly_q_gen(symbol, tp_field_added(&field, 0), field.ring);
  ck_assert_ptr_nonnull(strstr(tp_field_power(f, -1, &field), "division by zero"));
  ck_assert_ptr_nonnull(strstr(tp_field_power(symbol, 1001, &field), "exponent"));
  ck_assert_ptr_null(tp_field_problem(&field));
  fmpz_mpoly_q_set_si(f, 3, field.ring);
  ck_assert_ptr_null(tp_field_power(f, 1000, &field)); /* 1585 bits: its 64th power has 100000 */
  ck_assert_ptr_nonnull(tp_field_power(f, 64, &field));
  ck_assert(fmpz_mpoly_q_is_zero(f, field.ring));
  tp_field_add(f, f, symbol, &field);
  ck_assert(fmpz_mpoly_q_is_zero(f, field.ring));
  tp_field_forgive(&field);
  tp_field_add(f, f, symbol, &field);
  ck_assert(fmpz_mpoly_q_equal(f, symbol, field.ring));
  ck_assert(tp_field_spend(&field, TP_FIELD_BUDGET - field.work->spent));
  ck_assert(!tp_field_spend(&field, 1));
  tp_field_forgive(&field);
  ck_assert_ptr_nonnull(tp_field_problem(&field));
  fmpz_mpoly_q_clear(f, field.ring);
  fmpz_mpoly_q_clear(symbol, field.ring);
  tp_field_clear(&field);
}
END_TEST

SUITE(field) {
  Suite *suite = suite_create("field");
  TCase *cases = tcase_create("field");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, formulas_have_the_values_of_their_numbers);
  tcase_add_test(cases, equal_formulas_are_the_same);
  tcase_add_test(cases, work_has_an_end);
  suite_add_tcase(suite, cases);
  return suite;
}
