/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The three algebras of formulas agree with each other and with the truth.
 *
 * Random trees are written as texts with as few brackets as precedence allows, or a few more, and
 * evaluated while they are written: in GMP's rationals where they have only + - * / and whole
 * powers, in doubles where they have functions. The rationals of a scene's parameters and the
 * field of `derive` must give that rational, `verify`'s rational function too, and its ball must
 * hold it; of trees with functions balls must hold the double to its rounding, and meet the
 * rational function where there is one. */

#include "derive/field.h"
#include "random_numbers.h"
#include "runner.h"
#include "verify/evaluate.h"
#include "verify/subject_init.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TREES = 3000, SIZE = 4000, DEEPEST = 5, FIRST_NAMES = 4 };

/* Names and their values: a fraction, a decimal, a negative number, an angle in degrees. */
static const char *const names[FIRST_NAMES] = {"a", "b", "c", "theta"};
static const long tops[FIRST_NAMES] = {7, 5, -3, 37}, belows[FIRST_NAMES] = {3, 4, 2, 1};

/* How a text binds: a sum, a product, a sign, a power, a thing of its own. */
typedef enum binding { SUM, PRODUCT, SIGN, POWER, ATOM } binding;

typedef struct written {
  char text[SIZE];
  binding binds;
  mpq_t exact; /* where no functions are asked for */
  double value;
} written;

/* A formula as it is drawn. */
typedef struct drawing {
  random_numbers random;
  bool functions;
  bool fits; /* its numbers stay small, and away from where functions are steep */
} drawing;

static void written_init(written *w) {
  mpq_init(w->exact);
  w->value = 0;
  w->text[0] = '\0';
}

static void put(char *out, const char *text) {
  const size_t length = strlen(out);
  if (length + strlen(text) + 1 < SIZE) strcpy(out + length, text);
}

static void put_blank(drawing *d, char *out) {
  if (draw_below(&d->random, 3) == 0) put(out, " ");
}

/* A part within another, in brackets where it binds less than it must, and sometimes for nothing.
 */
static void put_part(drawing *d, char *out, const written *part, binding least) {
  const bool brackets = part->binds < least || draw_below(&d->random, 8) == 0;
  put_blank(d, out);
  if (brackets) put(out, "(");
  put(out, part->text);
  if (brackets) put(out, ")");
  put_blank(d, out);
}

static void draw_leaf(drawing *d, written *w) {
  const long which = draw_below(&d->random, 7);
  w->binds = ATOM;
  if (which < FIRST_NAMES) {
    put(w->text, names[which]);
    mpq_set_si(w->exact, tops[which], (unsigned long)belows[which]);
    mpq_canonicalize(w->exact);
  } else {
    char number[40];
    const long whole = draw_below(&d->random, 12), cents = draw_below(&d->random, 100);
    if (which == 4) {
      snprintf(number, sizeof number, "%ld.%02ld", whole, cents);
      mpq_set_si(w->exact, 100 * whole + cents, 100);
    } else if (which == 5) {
      snprintf(number, sizeof number, "%lde-1", cents);
      mpq_set_si(w->exact, cents, 10);
    } else {
      snprintf(number, sizeof number, "%ld", whole);
      mpq_set_si(w->exact, whole, 1);
    }
    mpq_canonicalize(w->exact);
    put(w->text, number);
  }
  w->value = mpq_get_d(w->exact);
}

static void draw_tree(drawing *d, written *w, int depth);

/* base^exponent for a whole exponent, written as a number, a negative one or a power. */
static void draw_power(drawing *d, written *w, int depth) {
  static const struct {
    const char *text;
    long value;
  } exponents[] = {{"2", 2}, {"3", 3},   {"-1", -1},     {"- 2", -2},
                   {"0", 0}, {"2^2", 4}, {"(1 + 1)", 2}, {"-1^3", -1}};
  const long which = draw_below(&d->random, sizeof exponents / sizeof exponents[0]);
  const long exponent = exponents[which].value;
  written base;
  written_init(&base);
  draw_tree(d, &base, depth - 1);
  put_part(d, w->text, &base, ATOM);
  put(w->text, "^");
  put(w->text, exponents[which].text);
  w->binds = POWER;
  w->value = pow(base.value, (double)exponent);
  if (!d->functions && mpq_sgn(base.exact) == 0 && exponent < 0) d->fits = false;
  if (d->functions && exponent < 0 && fabs(base.value) < 1e-2) d->fits = false;
  if (!d->functions && d->fits) {
    if (exponent < 0) mpq_inv(base.exact, base.exact);
    mpq_set_si(w->exact, 1, 1);
    for (long k = 0; k < labs(exponent); k++) mpq_mul(w->exact, w->exact, base.exact);
  }
  mpq_clear(base.exact);
}

static void draw_binary(drawing *d, written *w, int depth) {
  static const char *const operators[] = {"+", "-", "*", "/"};
  const long which = draw_below(&d->random, 4);
  written left, right;
  written_init(&left);
  written_init(&right);
  draw_tree(d, &left, depth - 1);
  draw_tree(d, &right, depth - 1);
  w->binds = which < 2 ? SUM : PRODUCT;
  put_part(d, w->text, &left, w->binds);
  put(w->text, operators[which]);
  put_part(d, w->text, &right, w->binds + 1);
  switch (which) {
  case 0:
    mpq_add(w->exact, left.exact, right.exact);
    w->value = left.value + right.value;
    break;
  case 1:
    mpq_sub(w->exact, left.exact, right.exact);
    w->value = left.value - right.value;
    break;
  case 2:
    mpq_mul(w->exact, left.exact, right.exact);
    w->value = left.value * right.value;
    break;
  default:
    d->fits = d->fits && (d->functions ? fabs(right.value) > 1e-2 : mpq_sgn(right.exact) != 0);
    if (d->fits && !d->functions) mpq_div(w->exact, left.exact, right.exact);
    w->value = left.value / right.value;
    break;
  }
  mpq_clear(left.exact);
  mpq_clear(right.exact);
}

static void draw_negative(drawing *d, written *w, int depth) {
  written of;
  written_init(&of);
  draw_tree(d, &of, depth - 1);
  w->binds = SIGN;
  put(w->text, "-");
  put_part(d, w->text, &of, SIGN);
  mpq_neg(w->exact, of.exact);
  w->value = -of.value;
  mpq_clear(of.exact);
}

static void draw_function(drawing *d, written *w, int depth) {
  static const char *const functions[] = {"sin",  "cos",  "tan",   "cot",
                                          "atan", "sqrt", "log10", "abs"};
  const double degree = acos(-1) / 180;
  const long which = draw_below(&d->random, 8);
  written of;
  written_init(&of);
  draw_tree(d, &of, depth - 1);
  w->binds = ATOM;
  put(w->text, functions[which]);
  put(w->text, "(");
  put(w->text, of.text);
  put(w->text, ")");
  const double x = of.value, sine = sin(x * degree), cosine = cos(x * degree);
  if (which < 4 && fabs(x) > 1e4) d->fits = false;
  if ((which == 2 && fabs(cosine) < 1e-2) || (which == 3 && fabs(sine) < 1e-2)) d->fits = false;
  if ((which == 5 || which == 6) && x < 1e-2) d->fits = false;
  const double values[] = {sine,    cosine,   sine / cosine, cosine / sine, atan(x) / degree,
                           sqrt(x), log10(x), fabs(x)};
  w->value = values[which];
  mpq_clear(of.exact);
}

static void draw_tree(drawing *d, written *w, int depth) {
  const long which = draw_below(&d->random, d->functions ? 14 : 10);
  if (depth == 0 || which == 0) {
    draw_leaf(d, w);
  } else if (which == 1) {
    draw_negative(d, w, depth);
  } else if (which < 4) {
    draw_power(d, w, depth);
  } else if (which < 10) {
    draw_binary(d, w, depth);
  } else {
    draw_function(d, w, depth);
  }
  const size_t bits =
      mpz_sizeinbase(mpq_numref(w->exact), 2) + mpz_sizeinbase(mpq_denref(w->exact), 2);
  if (!(fabs(w->value) < 1e6) || bits > 1500 || strlen(w->text) > SIZE / 4) d->fits = false;
}

/* Draw until a formula fits. */
static void draw_formula(written *w, random_numbers *random, bool functions) {
  for (;;) {
    drawing d = {.random = random_numbers_from(draw(random)), .functions = functions, .fits = true};
    w->text[0] = '\0';
    draw_tree(&d, w, 1 + (int)draw_below(random, DEEPEST));
    if (d.fits) return;
  }
}

/* A subject without a block, whose symbols are the names. */
static void make_subject(tp_subject *subject) {
  tp_declared declared[FIRST_NAMES];
  fmpq values[FIRST_NAMES];
  for (int k = 0; k < FIRST_NAMES; k++) {
    fmpq_init(values + k);
    fmpq_set_si(values + k, tops[k], (ulong)belows[k]);
    declared[k] = (tp_declared){names[k], values + k, k == FIRST_NAMES - 1};
  }
  const tp_subject_options options = {.declared_count = FIRST_NAMES, .declared = declared};
  tp_message message = {""};
  ck_assert_msg(tp_subject_init(subject, &options, (tp_place){0}, &message) == TP_OK, "%s",
                message.text);
  for (int k = 0; k < FIRST_NAMES; k++) fmpq_clear(values + k);
}

/* The rational function and the ball of a text; whether there is a rational function. */
static bool evaluate(fmpz_mpoly_q_t value, arb_t ball, const char *text, tp_subject *subject,
                     const tp_sample *sample) {
  tp_formula formula;
  tp_message message = {""};
  bool rational = false;
  ck_assert_msg(tp_subject_read(&formula, text, (tp_place){0}, subject, &message) == TP_OK,
                "%s: %s", text, message.text);
  ck_assert_msg(tp_evaluate_field(value, &rational, &formula, subject, &message) == TP_OK, "%s: %s",
                text, message.text);
  ck_assert_msg(tp_evaluate_ball(ball, &formula, subject, sample, true, 256, &message) == TP_OK,
                "%s: %s", text, message.text);
  tp_formula_clear(&formula);
  return rational;
}

START_TEST(verify_agrees_with_rationals) {
  random_numbers random = random_numbers_from(14);
  tp_subject subject;
  tp_sample sample;
  written w;
  fmpq_t truth, own;
  arb_t ball;
  fmpz_mpoly_q_t value;
  make_subject(&subject);
  ck_assert(tp_sample_init(&sample, &subject));
  written_init(&w);
  fmpq_init(truth);
  fmpq_init(own);
  arb_init(ball);
  fmpz_mpoly_q_init(value, subject.field->ring);
  for (long k = 0; k < TREES; k++) {
    draw_formula(&w, &random, false);
    fmpq_set_mpq(truth, w.exact);
    ck_assert_msg(evaluate(value, ball, w.text, &subject, &sample), "%s", w.text);
    ck_assert_msg(tp_field_evaluate_at(own, value, sample.values, subject.field) &&
                      fmpq_equal(own, truth),
                  "%s", w.text);
    ck_assert_msg(arb_contains_fmpq(ball, truth), "%s", w.text);
  }
  fmpz_mpoly_q_clear(value, subject.field->ring);
  arb_clear(ball);
  fmpq_clear(own);
  fmpq_clear(truth);
  mpq_clear(w.exact);
  tp_sample_clear(&sample);
  tp_subject_clear(&subject);
}
END_TEST

START_TEST(verify_agrees_with_doubles) {
  random_numbers random = random_numbers_from(15);
  long rational = 0;
  tp_subject subject;
  tp_sample sample;
  written w;
  arb_t ball, other;
  fmpz_mpoly_q_t value;
  make_subject(&subject);
  ck_assert(tp_sample_init(&sample, &subject));
  written_init(&w);
  arb_init(ball);
  arb_init(other);
  fmpz_mpoly_q_init(value, subject.field->ring);
  for (long k = 0; k < TREES; k++) {
    draw_formula(&w, &random, true);
    const bool known = evaluate(value, ball, w.text, &subject, &sample);
    const double middle = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
    ck_assert_msg(fabs(middle - w.value) <= 1e-6 * (1 + fabs(w.value)), "%s: %.17g, not %.17g",
                  w.text, middle, w.value);
    rational += known;
    if (!known) continue;
    tp_sample_evaluate(other, value, &sample, &subject, 256);
    ck_assert_msg(arb_overlaps(ball, other), "%s", w.text);
  }
  ck_assert_int_gt(rational, TREES / 20);
  ck_assert_int_lt(rational, TREES - TREES / 20);
  fmpz_mpoly_q_clear(value, subject.field->ring);
  arb_clear(ball);
  arb_clear(other);
  mpq_clear(w.exact);
  tp_sample_clear(&sample);
  tp_subject_clear(&subject);
}
END_TEST

/* Parameters of a scene, each a tree in the first four: their values in rationals, and in the field
 * where these are symbols. */
START_TEST(scenes_and_derive_agree_with_rationals) {
  enum { ROUNDS = 100, EACH = 30, SHORT = 40 }; /* derive takes so many terms in one number */
  random_numbers random = random_numbers_from(16);
  char *text = malloc((size_t)EACH * (SIZE + 40) + 400);
  ck_assert_ptr_nonnull(text);
  for (long round = 0; round < ROUNDS; round++) {
    written all[EACH];
    size_t length = (size_t)sprintf(text, "topple: 1\nlength_unit: m\nparameters:\n");
    for (int k = 0; k < FIRST_NAMES; k++)
      length += (size_t)sprintf(text + length, "  %s: %ld/%ld\n", names[k], tops[k], belows[k]);
    for (int k = 0; k < EACH; k++) {
      written_init(all + k);
      do draw_formula(all + k, &random, false);
      while (strlen(all[k].text) > SHORT);
      length += (size_t)sprintf(text + length, "  p%d: '%s'\n", k, all[k].text);
    }
    sprintf(text + length, "block: {slab: {width: 1, height: 2}}\nbase: {mated: true}\n");
    tp_scene *scene = NULL;
    tp_field field;
    tp_message message = {""};
    ck_assert_msg(tp_scene_read_text(&scene, text, "s", &message) == TP_OK, "%s", message.text);
    ck_assert_msg(tp_field_init(&field, scene, NULL, &message) == TP_OK, "%s", message.text);
    fmpq_t truth, own;
    fmpq_init(truth);
    fmpq_init(own);
    for (int k = 0; k < EACH; k++) {
      const long p = FIRST_NAMES + k;
      fmpq_set_mpq(truth, all[k].exact);
      ck_assert_msg(fmpq_equal(scene->parameters.values + p, truth), "%s", all[k].text);
      ck_assert_msg(tp_field_evaluate(own, field.values + p, &field) && fmpq_equal(own, truth),
                    "%s", all[k].text);
      mpq_clear(all[k].exact);
    }
    fmpq_clear(truth);
    fmpq_clear(own);
    tp_field_clear(&field);
    tp_scene_free(scene);
  }
  free(text);
}
END_TEST

int main(void) {
  Suite *suite = suite_create("algebras");
  TCase *algebras = tcase_create("algebras");
  tcase_set_timeout(algebras, 300);
  tcase_add_test(algebras, verify_agrees_with_rationals);
  tcase_add_test(algebras, verify_agrees_with_doubles);
  tcase_add_test(algebras, scenes_and_derive_agree_with_rationals);
  suite_add_tcase(suite, algebras);
  return run_suite(suite);
}
