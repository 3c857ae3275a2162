/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "scene/expression.h"

#include "number/ratio.h"
#include "outside.h"

#include <ctype.h>
#include <stdalign.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { MOST_DEPTH = 200 };

typedef struct parser {
  const char *text, *at;
  tp_place place;
  const tp_algebra *algebra;
  const void *context;
  tp_message *message;
  int depth;
  tp_status status;
} parser;

/* A value of whatever algebra, on the stack. */
typedef struct operand {
  _Alignas(max_align_t) unsigned char bytes[TP_ALGEBRA_SIZE];
} operand;

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

static bool sum(parser *p, void *value);

static bool name_value(parser *p, void *value) {
  const char *start = p->at;
  while (continues_name(*p->at)) p->at++;
  const size_t length = (size_t)(p->at - start);
  if (p->algebra->set_name(value, start, length, p->context)) return true;
  const tp_quote name = tp_quote_of(start, length);
  if (tp_expression_is_not_finite(name.text)) {
    return fail_at(p, start, "'%s' is not a finite number", name.text);
  }
  skip_space(p);
  if (*p->at == '(') {
    return fail_at(p, start,
                   "'%s(…)' is no exact operation; expressions take + - * / ^ and parentheses, "
                   "so write its value as a number",
                   name.text);
  }
  return fail_at(p, start, "unknown name '%s'; define it under 'parameters', before its first use",
                 name.text);
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

/* value = value op other, with the operator's place for a complaint. */
static bool combine(parser *p, void *value, const char *op, const void *other) {
  const char *problem = p->algebra->combine(value, *op, other, p->context);
  return problem == NULL || fail_at(p, op, "%s", problem);
}

static bool number(parser *p, void *value) {
  const char *problem = NULL;
  fmpq_t decimal;
  fmpq_init(decimal);
  const size_t used = tp_ratio_read_decimal(decimal, p->at, strlen(p->at), &problem);
  if (used > 0) p->algebra->set_number(value, decimal, p->context);
  fmpq_clear(decimal);
  if (used == 0) {
    const size_t length = word_length(p->at);
    if (tp_expression_is_not_finite(p->at)) problem = "is not a finite number";
    return fail_at(p, p->at, "'%s' %s", tp_quote_of(p->at, length).text, problem);
  }
  p->at += used;
  return true;
}

static bool primary(parser *p, void *value) {
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
  return number(p, value);
}

/* Signs and powers: -2^2 is -(2^2), 2^-1 is allowed, 2^3^2 is 2^(3^2). */
static bool signed_power(parser *p, void *value) {
  if (++p->depth > MOST_DEPTH) return fail_at(p, p->at, "nested deeper than 200 levels");
  skip_space(p);
  bool done = true;
  if (*p->at == '-' || *p->at == '+') {
    const bool negative = *p->at++ == '-';
    done = signed_power(p, value);
    if (done && negative) p->algebra->negate(value, p->context);
  } else {
    done = primary(p, value);
    skip_space(p);
    if (done && *p->at == '^') {
      const char *op = p->at++;
      operand exponent;
      p->algebra->init(&exponent, p->context);
      done = signed_power(p, &exponent) && combine(p, value, op, &exponent);
      p->algebra->clear(&exponent, p->context);
    }
  }
  p->depth--;
  return done;
}

/* Operands of one precedence from left to right. */
static bool chain(parser *p, void *value, const char *operators,
                  bool (*operand_of)(parser *, void *)) {
  if (!operand_of(p, value)) return false;
  operand other;
  p->algebra->init(&other, p->context);
  bool done = true;
  for (skip_space(p); done && *p->at != '\0' && strchr(operators, *p->at) != NULL; skip_space(p)) {
    const char *op = p->at++;
    done = operand_of(p, &other) && combine(p, value, op, &other);
  }
  p->algebra->clear(&other, p->context);
  return done;
}

static bool product(parser *p, void *value) {
  return chain(p, value, "*/", signed_power);
}

static bool sum(parser *p, void *value) {
  return chain(p, value, "+-", product);
}

tp_status tp_expression_read(void *value, const tp_algebra *algebra, const void *context,
                             const char *text, tp_place place, tp_message *message) {
  parser p = {.text = text,
              .at = text,
              .place = place,
              .algebra = algebra,
              .context = context,
              .message = message};
  skip_space(&p);
  if (*p.at == '\0') {
    fail_at(&p, p.at, "a number belongs here");
  } else if (sum(&p, value) && *p.at != '\0') {
    fail_at(&p, p.at, "'%s' does not continue a number or an expression", tp_quote_all(p.at).text);
  }
  return p.status;
}
