/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "scene/expression.h"

#include "number/ratio.h"
#include "scene/node.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_DEPTH = 200, MOST_BITS = 20000 };

typedef struct parser {
  const char *text, *at;
  tp_place place;
  const tp_parameters *parameters;
  tp_message *message;
  int depth;
  tp_status status;
} parser;

__attribute__((format(printf, 3, 4))) static bool fail_at(parser *p, const char *at,
                                                          const char *format, ...) {
  char text[512];
  tp_place place = p->place;
  if (place.column > 0) place.column += (int)(at - p->text);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  p->status = tp_fail(p->message, TP_BAD_INPUT, place, "%s", text);
  return false;
}

static bool starts_name(char c) {
  return isalpha((unsigned char)c) || c == '_';
}

static bool continues_name(char c) {
  return starts_name(c) || isdigit((unsigned char)c);
}

bool tp_expression_is_name(const char *text) {
  if (!starts_name(*text)) return false;
  while (continues_name(*text)) text++;
  return *text == '\0';
}

bool tp_expression_is_not_finite(const char *text) {
  static const char *const words[] = {"nan", "inf", "infinity", NULL};
  if (*text == '+' || *text == '-') text++;
  if (*text == '.') text++;
  for (size_t k = 0; words[k] != NULL; k++) {
    if (strcasecmp(text, words[k]) == 0) return true;
  }
  return false;
}

static void skip_space(parser *p) {
  while (*p->at == ' ' || *p->at == '\t') p->at++;
}

static bool bounded(parser *p, const fmpq_t value, const char *at) {
  if (fmpz_bits(fmpq_numref(value)) + fmpz_bits(fmpq_denref(value)) <= MOST_BITS) return true;
  return fail_at(p, at, "the value grows beyond 20 000 bits here");
}

static bool sum(parser *p, fmpq_t value);

static bool name_value(parser *p, fmpq_t value) {
  const char *start = p->at;
  while (continues_name(*p->at)) p->at++;
  const int length = (int)(p->at - start);
  const tp_parameters *known = p->parameters;
  for (long k = known != NULL ? known->count - 1 : -1; k >= 0; k--) {
    if (strlen(known->names[k]) == (size_t)length &&
        strncmp(known->names[k], start, (size_t)length) == 0) {
      fmpq_set(value, known->values + k);
      return true;
    }
  }
  char word[64] = "";
  strncat(word, start, (size_t)(length < 63 ? length : 63));
  if (tp_expression_is_not_finite(word)) {
    return fail_at(p, start, "'%.*s' is not a finite number", length, start);
  }
  skip_space(p);
  if (*p->at == '(') {
    return fail_at(p, start,
                   "'%.*s(…)' is no exact operation; expressions take + - * / ^ and parentheses, "
                   "so write its value as a number",
                   length, start);
  }
  return fail_at(p, start,
                 "unknown name '%.*s'; define it under 'parameters', before its first use", length,
                 start);
}

/* What stands at `text` as one word for a message: a number with its exponent, or what looks like
 * one. */
static size_t word_length(const char *text) {
  size_t length = 0;
  while (text[length] != '\0' && strchr(" \t*/^()", text[length]) == NULL) {
    const bool sign = text[length] == '+' || text[length] == '-';
    if (sign && (length == 0 || strchr("eE", text[length - 1]) == NULL)) break;
    length++;
  }
  return length > 0 ? length : 1;
}

static bool primary(parser *p, fmpq_t value) {
  skip_space(p);
  if (*p->at == '(') {
    const char *open = p->at++;
    if (!sum(p, value)) return false;
    skip_space(p);
    if (*p->at != ')') return fail_at(p, open, "this '(' is not closed");
    p->at++;
    return true;
  }
  if (starts_name(*p->at)) return name_value(p, value);
  if (*p->at == '\0') return fail_at(p, p->at, "a number is missing at the end");
  const char *problem = NULL;
  const size_t used = tp_ratio_read_decimal(value, p->at, strlen(p->at), &problem);
  if (used == 0) {
    const size_t length = word_length(p->at);
    if (tp_expression_is_not_finite(p->at)) problem = "is not a finite number";
    return fail_at(p, p->at, "'%.*s' %s", (int)(length < 40 ? length : 40), p->at, problem);
  }
  p->at += used;
  return true;
}

static bool power_of(parser *p, fmpq_t base, const fmpq_t exponent, const char *at) {
  if (!fmpz_is_one(fmpq_denref(exponent))) {
    return fail_at(p, at, "an exponent must be a whole number");
  }
  if (fmpq_is_zero(base) && fmpq_sgn(exponent) < 0) {
    return fail_at(p, at, "division by zero: zero to a negative power");
  }
  const double bits = (double)(fmpz_bits(fmpq_numref(base)) + fmpz_bits(fmpq_denref(base)));
  const double size = bits * fabs(fmpz_get_d(fmpq_numref(exponent)));
  if (size > MOST_BITS || !fmpz_fits_si(fmpq_numref(exponent))) {
    return fail_at(p, at, "the value grows beyond 20 000 bits here");
  }
  fmpq_pow_si(base, base, fmpz_get_si(fmpq_numref(exponent)));
  return true;
}

/* Signs and powers: -2^2 is -(2^2), 2^-1 is allowed, 2^3^2 is 2^(3^2). */
static bool signed_power(parser *p, fmpq_t value) {
  if (++p->depth > MOST_DEPTH) {
    return fail_at(p, p->at, "nested deeper than 200 levels");
  }
  skip_space(p);
  bool done = true;
  if (*p->at == '-' || *p->at == '+') {
    const bool negative = *p->at++ == '-';
    done = signed_power(p, value);
    if (done && negative) fmpq_neg(value, value);
  } else {
    done = primary(p, value);
    skip_space(p);
    if (done && *p->at == '^') {
      const char *at = p->at++;
      fmpq_t exponent;
      fmpq_init(exponent);
      done = signed_power(p, exponent) && power_of(p, value, exponent, at);
      fmpq_clear(exponent);
    }
  }
  p->depth--;
  return done;
}

static bool product(parser *p, fmpq_t value) {
  if (!signed_power(p, value)) return false;
  fmpq_t factor;
  fmpq_init(factor);
  bool done = true;
  for (skip_space(p); done && (*p->at == '*' || *p->at == '/'); skip_space(p)) {
    const char *at = p->at++;
    done = signed_power(p, factor);
    if (!done) break;
    if (*at == '*') {
      fmpq_mul(value, value, factor);
    } else if (fmpq_is_zero(factor)) {
      done = fail_at(p, at, "division by zero");
    } else {
      fmpq_div(value, value, factor);
    }
    done = done && bounded(p, value, at);
  }
  fmpq_clear(factor);
  return done;
}

static bool sum(parser *p, fmpq_t value) {
  if (!product(p, value)) return false;
  fmpq_t term;
  fmpq_init(term);
  bool done = true;
  for (skip_space(p); done && (*p->at == '+' || *p->at == '-'); skip_space(p)) {
    const char *at = p->at++;
    done = product(p, term);
    if (!done) break;
    if (*at == '+') {
      fmpq_add(value, value, term);
    } else {
      fmpq_sub(value, value, term);
    }
    done = bounded(p, value, at);
  }
  fmpq_clear(term);
  return done;
}

tp_status tp_expression_evaluate(fmpq_t value, const char *text, tp_place place,
                                 const tp_parameters *parameters, tp_message *message) {
  parser p = {
      .text = text, .at = text, .place = place, .parameters = parameters, .message = message};
  fmpq_t result;
  fmpq_init(result);
  bool done = true;
  skip_space(&p);
  if (*p.at == '\0') done = fail_at(&p, p.at, "a number belongs here");
  done = done && sum(&p, result);
  if (done && *p.at != '\0') {
    fail_at(&p, p.at, "'%.*s' does not continue a number or an expression", (int)strnlen(p.at, 40),
            p.at);
  }
  if (p.status == TP_OK) fmpq_set(value, result);
  fmpq_clear(result);
  return p.status;
}
