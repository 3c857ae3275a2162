/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes polynomials term by term into a memory stream, with powers multiplied out and coefficients
 * scaled to the range of doubles in C. */

#define _POSIX_C_SOURCE 200809L /* open_memstream */
#include "derive/notation.h"

#include "derive/field_work.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  MOST_FACTORS = 8,  /* a power in C is written out up to here */
  DOUBLE_BITS = 1000 /* whole numbers below 2^1000 are constants that a double holds */
};

/* sin(i) and the like are symbols too. */
static void add_latex_name(FILE *out, const char *name) {
  const char *bracket = strchr(name, '(');
  if (bracket != NULL) {
    const int argument = (int)strlen(bracket + 1) - 1;
    fprintf(out, "\\%.*s %s%.*s", (int)(bracket - name), name, argument > 1 ? "\\" : "", argument,
            bracket + 1);
    return;
  }
  if (isalpha((unsigned char)name[0]) && name[1] == '\0') {
    fputs(name, out);
    return;
  }
  fputs("\\mathrm{", out);
  for (const char *c = name; *c != '\0'; c++) {
    if (*c == '_') fputc('\\', out);
    fputc(*c, out);
  }
  fputs("}", out);
}

/* A factor name^exponent; `first`: nothing stands before it in the term. */
static void add_factor(FILE *out, const char *name, slong exponent, bool first,
                       tp_notation notation) {
  switch (notation) {
  case TP_NOTATION_TEXT:
    fprintf(out, "%s%s", first ? "" : "*", name);
    if (exponent > 1) fprintf(out, "^%ld", (long)exponent);
    break;
  case TP_NOTATION_LATEX:
    if (!first) fputs(" ", out);
    if (exponent > 1 && strchr(name, '(') != NULL) fputs("(", out);
    add_latex_name(out, name);
    if (exponent > 1 && strchr(name, '(') != NULL) fputs(")", out);
    if (exponent > 1) fprintf(out, "^{%ld}", (long)exponent);
    break;
  case TP_NOTATION_C:
    if (exponent > MOST_FACTORS) {
      fprintf(out, "%spow(%s, %ld.0)", first ? "" : "*", name, (long)exponent);
      break;
    }
    for (slong k = 0; k < exponent; k++) fprintf(out, "%s%s", first && k == 0 ? "" : "*", name);
    break;
  }
}

/* A positive whole number; in C a floating constant of its value over 2^shift. */
static void write_coefficient(FILE *out, const fmpz_t number, long shift, tp_notation notation) {
  if (notation == TP_NOTATION_C && shift > 0) {
    arf_t value;
    arf_init(value);
    arf_set_fmpz(value, number);
    arf_mul_2exp_si(value, value, -shift);
    fprintf(out, "%.17e", arf_get_d(value, ARF_RND_NEAR));
    arf_clear(value);
    return;
  }
  char *digits = fmpz_get_str(NULL, 10, number);
  fprintf(out, "%s%s", digits, notation == TP_NOTATION_C ? ".0" : "");
  flint_free(digits);
}

/* In C numerator and denominator are both divided by a power of two where their numbers are larger
 * than a double holds. */
static long shift_of(const fmpz_mpoly_q_t fraction) {
  const long top = labs(fmpz_mpoly_max_bits(fmpz_mpoly_q_numref(fraction)));
  const long below = labs(fmpz_mpoly_max_bits(fmpz_mpoly_q_denref(fraction)));
  const long most = top > below ? top : below;
  return most > DOUBLE_BITS ? most - DOUBLE_BITS : 0;
}

static void add_term(FILE *out, const fmpz_mpoly_t polynomial, slong t, const tp_field *field,
                     tp_notation notation, long shift) {
  fmpz_t coefficient;
  fmpz_init(coefficient);
  fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, t, field->ring);
  const bool negative = fmpz_sgn(coefficient) < 0;
  if (negative) fmpz_neg(coefficient, coefficient);
  if (t > 0) {
    fputs(negative ? " - " : " + ", out);
  } else if (negative) {
    fputs("-", out);
  }
  slong *exponents = flint_malloc((size_t)field->symbol_count * sizeof *exponents);
  fmpz_mpoly_get_term_exp_si(exponents, polynomial, t, field->ring);
  bool constant = true;
  for (long k = 0; k < field->symbol_count; k++) constant = constant && exponents[k] == 0;
  bool first = fmpz_is_one(coefficient) && !constant && shift == 0;
  if (!first) {
    write_coefficient(out, coefficient, shift, notation);
  }
  for (long k = 0; k < field->symbol_count; k++) {
    if (exponents[k] == 0) continue;
    add_factor(out, field->names[k], exponents[k], first, notation);
    first = false;
  }
  flint_free(exponents);
  fmpz_clear(coefficient);
}

static void add_polynomial(FILE *out, const fmpz_mpoly_t polynomial, const tp_field *field,
                           tp_notation notation, long shift) {
  const slong terms = fmpz_mpoly_length(polynomial, field->ring);
  if (terms == 0) fputs(notation == TP_NOTATION_C ? "0.0" : "0", out);
  for (slong t = 0; t < terms; t++) add_term(out, polynomial, t, field, notation, shift);
}

static bool is_symbol(const fmpz_mpoly_t polynomial, const tp_field *field) {
  bool symbol = false;
  for (long k = 0; k < field->symbol_count; k++) {
    symbol = symbol || fmpz_mpoly_is_gen(polynomial, k, field->ring);
  }
  return symbol;
}

static void add_fraction(FILE *out, const fmpz_mpoly_q_t fraction, const tp_field *field,
                         tp_notation notation) {
  const fmpz_mpoly_struct *top = fmpz_mpoly_q_numref(fraction);
  const fmpz_mpoly_struct *below = fmpz_mpoly_q_denref(fraction);
  const long shift = notation == TP_NOTATION_C ? shift_of(fraction) : 0;
  if (fmpz_mpoly_is_one(below, field->ring) && shift == 0) {
    add_polynomial(out, top, field, notation, shift);
    return;
  }
  if (notation == TP_NOTATION_LATEX) {
    fputs("\\frac{", out);
    add_polynomial(out, top, field, notation, 0);
    fputs("}{", out);
    add_polynomial(out, below, field, notation, shift);
    fputs("}", out);
    return;
  }
  const bool sum = fmpz_mpoly_length(top, field->ring) > 1;
  const bool bare = fmpz_mpoly_is_fmpz(below, field->ring) || is_symbol(below, field);
  fputs(sum ? "(" : "", out);
  add_polynomial(out, top, field, notation, shift);
  fputs(sum ? ")" : "", out);
  fputs(bare ? "/" : "/(", out);
  add_polynomial(out, below, field, notation, shift);
  fputs(bare ? "" : ")", out);
}

enum part { NUMERATOR, DENOMINATOR, WHOLE };

/* What writing takes; where there is no room for it the text is empty, and never read. */
static double writing_units(const fmpz_mpoly_struct *p, const tp_field *field) {
  return 0.3 * (double)p->length * (1 + (double)labs(fmpz_mpoly_max_bits(p)) / 64) *
         (1 + (double)field->symbol_count / 64);
}

static char *part_text(const fmpz_mpoly_q_t fraction, enum part part, const tp_field *field,
                       tp_notation notation) {
  if (!tp_field_spend(field, writing_units(fmpz_mpoly_q_numref(fraction), field) +
                                 writing_units(fmpz_mpoly_q_denref(fraction), field))) {
    return strdup("");
  }
  char *text = NULL;
  size_t length = 0;
  FILE *out = open_memstream(&text, &length);
  if (out == NULL) return NULL;
  switch (part) {
  case NUMERATOR:
    add_polynomial(out, fmpz_mpoly_q_numref(fraction), field, notation, 0);
    break;
  case DENOMINATOR:
    add_polynomial(out, fmpz_mpoly_q_denref(fraction), field, notation, 0);
    break;
  case WHOLE:
    add_fraction(out, fraction, field, notation);
    break;
  }
  return fclose(out) == 0 ? text : NULL;
}

tp_fraction tp_notation_write(const fmpz_mpoly_q_t formula, const tp_field *field,
                              tp_notation notation, bool *failed) {
  const tp_fraction f = {part_text(formula, NUMERATOR, field, notation),
                         part_text(formula, DENOMINATOR, field, notation),
                         part_text(formula, WHOLE, field, notation)};
  if (f.numerator == NULL || f.denominator == NULL || f.formula == NULL) *failed = true;
  return f;
}

tp_fraction tp_notation_write_quotient(const fmpz_mpoly_q_t top, const fmpz_mpoly_q_t below,
                                       const tp_field *field, tp_notation notation, bool *failed) {
  tp_fraction f;
  if (fmpz_mpoly_q_is_zero(below, field->ring)) {
    f = tp_notation_write(top, field, notation, failed);
    free(f.denominator);
    free(f.formula);
    f.denominator = strdup("0");
    f.formula = strdup(notation == TP_NOTATION_C ? "INFINITY" : "unbounded");
    if (f.denominator == NULL || f.formula == NULL) *failed = true;
    return f;
  }
  fmpz_mpoly_q_t value;
  fmpz_mpoly_q_init(value, field->ring);
  tp_field_div(value, top, below, field);
  f = tp_notation_write(value, field, notation, failed);
  fmpz_mpoly_q_clear(value, field->ring);
  return f;
}

void tp_notation_free(tp_fraction *fraction) {
  free(fraction->numerator);
  free(fraction->denominator);
  free(fraction->formula);
}
