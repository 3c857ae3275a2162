/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A formula into its syntax tree, by recursive descent: sums, products, powers, words. The time is
 * proportional to the length of the text, but for names that are looked up. */

#include "formula/read.h"

#include "common/outside.h"
#include "formula/parser.h"

#include <limits.h>
#include <string.h>

enum { MOST_DEPTH = 200 };

static long sum(tp_parser *p);
static long factor(tp_parser *p);
static long word(tp_parser *p, bool as_argument);

/* Between an opening bracket here and its partner. */
static long bracketed(tp_parser *p, char close) {
  const int open = p->at++;
  const long inner = sum(p);
  if (inner < 0) return -1;
  tp_parser_skip_blanks(p);
  if (*tp_parser_here(p) != close)
    return tp_parser_fail(p, open, "this '%c' is not closed", p->formula->text[open]);
  p->at++;
  p->formula->nodes[inner].begin = open;
  p->formula->nodes[inner].end = p->at;
  return inner;
}

/* What a function is taken of: brackets, a name or a number. */
static long argument(tp_parser *p, const char *function) {
  tp_parser_skip_blanks(p);
  if (*tp_parser_here(p) == '(') return bracketed(p, ')');
  if (*tp_parser_here(p) != '.' && tp_parser_begins_number(p)) return tp_parser_number(p);
  if (tp_parser_begins_word(p)) return word(p, true);
  return tp_parser_fail(p, p->at, "%s of what? Write %s(x)", function, function);
}

/* sin, sin^2 or tan^-1, and what it is taken of. */
static long application(tp_parser *p, tp_function function, tp_span own) {
  const char *name = tp_function_name(function);
  char op;
  long exponent = -1;
  bool inverse = false;
  const int mark = p->at, used = tp_parser_operator(p, &op);
  const int power_at = p->at;
  if (op == '^') {
    p->at += used;
    exponent = factor(p);
    if (exponent < 0) return -1;
    const tp_formula_node *e = p->formula->nodes + exponent;
    inverse = e->kind == TP_FORMULA_NEGATE &&
              p->formula->nodes[e->left].kind == TP_FORMULA_NUMBER &&
              fmpq_is_one(&p->formula->nodes[e->left].value);
    if (inverse && function != TP_FUNCTION_TAN) {
      return tp_parser_fail(
          p, own.at, "what does %s^-1 mean? Write 1/%s(x), or an inverse function", name, name);
    }
  } else {
    p->at = mark;
  }
  const long of = argument(p, name);
  if (of < 0) return -1;
  if (inverse) {
    const tp_formula_node *n = p->formula->nodes + of;
    const bool angle =
        n->kind == TP_FORMULA_NAME && p->vocabulary->is_angle(p->vocabulary->context, n->name);
    function = angle ? TP_FUNCTION_COT : TP_FUNCTION_ATAN;
  }
  const long value = tp_parser_unary(p, TP_FORMULA_CALL, of, own);
  if (value < 0) return -1;
  p->formula->nodes[value].function = function;
  if (exponent < 0 || inverse) return value;
  return tp_parser_binary(p, TP_FORMULA_POWER, value, exponent, (tp_span){power_at, used});
}

/* A name, or a function of something; as an argument a function is none. */
static long word(tp_parser *p, bool as_argument) {
  tp_word found;
  if (!tp_parser_word(p, &found, as_argument)) return -1;
  if (found.is_function) return application(p, found.function, found.own);
  const long node = tp_parser_leaf(p, TP_FORMULA_NAME, found.own);
  if (node >= 0) p->formula->nodes[node].name = found.name;
  return node;
}

static long primary(tp_parser *p) {
  tp_parser_skip_blanks(p);
  const char first = *tp_parser_here(p);
  if (first == '(') return bracketed(p, ')');
  if (first == '{' && p->dialect->letters) return bracketed(p, '}');
  if (first == '\0')
    return tp_parser_fail(p, p->at, "%s is missing at the end", p->dialect->operand);
  if (tp_parser_begins_number(p)) return tp_parser_number(p);
  if (tp_parser_begins_word(p)) return word(p, false);
  return tp_parser_fail_at_word(p, p->dialect->no_operand);
}

/* Signs and powers: -2^2 is -(2^2), 2^3^2 is 2^(3^2). */
static long factor(tp_parser *p) {
  if (++p->depth > MOST_DEPTH)
    return tp_parser_fail(p, p->at, "nested deeper than %d levels", MOST_DEPTH);
  char op;
  int used = tp_parser_operator(p, &op);
  const int at = p->at;
  long value;
  if (op == '+' || op == '-') {
    p->at += used;
    value = factor(p);
    if (value >= 0 && op == '-')
      value = tp_parser_unary(p, TP_FORMULA_NEGATE, value, (tp_span){at, used});
  } else {
    value = primary(p);
    if (value >= 0 && (used = tp_parser_operator(p, &op)) > 0 && op == '^') {
      const int mark = p->at;
      p->at += used;
      const long exponent = factor(p);
      value = exponent < 0
                  ? -1
                  : tp_parser_binary(p, TP_FORMULA_POWER, value, exponent, (tp_span){mark, used});
    }
  }
  p->depth--;
  return value;
}

/* Does a factor begin here without an operator, as in 27ab? */
static bool factor_follows(tp_parser *p) {
  if (!p->dialect->products) return false;
  tp_parser_skip_blanks(p);
  return *tp_parser_here(p) == '(' || tp_parser_begins_word(p);
}

static long product(tp_parser *p) {
  long value = factor(p);
  bool divided = false;
  while (value >= 0) {
    char op;
    const int used = tp_parser_operator(p, &op), at = p->at;
    const bool written = op == '*' || op == '/';
    if (!written && !(op == '\0' && factor_follows(p))) break;
    if (!written && divided) {
      return tp_parser_fail(
          p, at,
          "is this factor above or below the stroke? Write '*' or put brackets round "
          "the divisor");
    }
    p->at += written ? used : 0;
    const long other = factor(p);
    if (other < 0) return -1;
    const bool divide = op == '/';
    value = tp_parser_binary(p, divide ? TP_FORMULA_DIVIDE : TP_FORMULA_MULTIPLY, value, other,
                             (tp_span){at, written ? used : 0});
    divided = divide || (divided && !written);
  }
  return value;
}

static long sum(tp_parser *p) {
  long value = product(p);
  while (value >= 0) {
    char op;
    const int used = tp_parser_operator(p, &op), at = p->at;
    if (op != '+' && op != '-') break;
    p->at += used;
    const long other = product(p);
    if (other < 0) return -1;
    value = tp_parser_binary(p, op == '+' ? TP_FORMULA_ADD : TP_FORMULA_SUBTRACT, value, other,
                             (tp_span){at, used});
  }
  return value;
}

tp_status tp_formula_read_into(tp_formula *formula, tp_formula_node *lent, long count,
                               const char *text, tp_place place, const tp_dialect *dialect,
                               const tp_vocabulary *vocabulary, tp_message *message) {
  *formula =
      (tp_formula){.text = text, .place = place, .capacity = count, .nodes = lent, .lent = lent};
  tp_parser p = {.formula = formula,
                 .dialect = dialect,
                 .vocabulary = vocabulary,
                 .message = message,
                 .size = strlen(text)};
  if (p.size > INT_MAX) {
    tp_parser_fail(&p, 0, "%s of more than %d bytes", dialect->formula, INT_MAX);
    tp_formula_clear(formula);
    return p.status;
  }
  tp_parser_skip_blanks(&p);
  if (*tp_parser_here(&p) == '\0') {
    tp_parser_fail(&p, p.at, "%s belongs here", dialect->formula);
  } else if (sum(&p) >= 0) {
    tp_parser_skip_blanks(&p);
    if (*tp_parser_here(&p) != '\0') {
      const tp_quote stray = tp_quote_of(tp_parser_here(&p), dialect->quoted);
      tp_parser_fail(&p, p.at, "'%s' does not continue %s", stray.text, dialect->continued);
    }
  }
  if (p.status != TP_OK) tp_formula_clear(formula);
  return p.status;
}

tp_status tp_formula_read(tp_formula *formula, const char *text, tp_place place,
                          const tp_dialect *dialect, const tp_vocabulary *vocabulary,
                          tp_message *message) {
  return tp_formula_read_into(formula, NULL, 0, text, place, dialect, vocabulary, message);
}
