/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "formula_drawing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 5 };

const char *const names[FIRST_NAMES] = {"a", "b", "c", "theta"};
const long tops[FIRST_NAMES] = {7, 5, -3, 37}, belows[FIRST_NAMES] = {3, 4, 2, 1};

/* A formula as it is drawn. */
typedef struct drawing {
  random_numbers random;
  bool functions;
  bool fits; /* its numbers stay small, and away from where functions are steep */
} drawing;

void written_init(written *w) {
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

void draw_formula(written *w, random_numbers *random, bool functions) {
  for (;;) {
    drawing d = {.random = random_numbers_from(draw(random)), .functions = functions, .fits = true};
    w->text[0] = '\0';
    draw_tree(&d, w, 1 + (int)draw_below(random, DEEPEST));
    if (d.fits) return;
  }
}
