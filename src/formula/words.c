/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names and functions in a formula: the longest front of the letters that is known, by a look at
 * every front where factors may stand side by side, else the whole word alone. */

#include "formula/parser.h"

#include "formula/spelling.h"
#include "number/ratio.h"
#include "outside.h"

#include <stdint.h>
#include <string.h>

static const char *const functions[] = {"sin", "cos", "tan", "cot", "atan", "sqrt", "log10", "abs"};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

/* The front of a word. */
typedef struct front {
  const char *name; /* not terminated, Greek letters spelt out */
  size_t length;
  size_t used; /* bytes of the text; 0: no name */
  char spelt[TP_NAME_SIZE];
} front;

static void take_front(front *f, const tp_parser *p, size_t most) {
  if (p->dialect->letters) {
    f->used = tp_name_spell(f->spelt, sizeof f->spelt, tp_parser_here(p), most);
    f->name = f->spelt;
    f->length = strlen(f->spelt);
  } else {
    const size_t all = tp_name_length(tp_parser_here(p));
    f->used = f->length = all < most ? all : most;
    f->name = tp_parser_here(p);
  }
}

/* What a function is taken of: brackets, a name or a number. */
static long argument(tp_parser *p, const char *function) {
  tp_parser_skip_blanks(p);
  if (*tp_parser_here(p) == '(') return tp_parser_bracketed(p, ')');
  if (*tp_parser_here(p) != '.' && tp_parser_begins_number(p)) return tp_parser_number(p);
  if (tp_parser_begins_word(p)) return tp_parser_word(p, true);
  return tp_parser_fail(p, p->at, "%s of what? Write %s(x)", function, function);
}

/* sin, sin^2 or tan^-1, and what it is taken of. */
static long application(tp_parser *p, tp_function function, int at, int length) {
  char op;
  long exponent = -1;
  bool inverse = false;
  const int mark = p->at, used = tp_parser_operator(p, &op);
  const int power_at = p->at;
  if (op == '^') {
    p->at += used;
    exponent = tp_parser_factor(p);
    if (exponent < 0) return -1;
    const tp_formula_node *e = p->formula->nodes + exponent;
    inverse = e->kind == TP_FORMULA_NEGATE &&
              p->formula->nodes[e->left].kind == TP_FORMULA_NUMBER &&
              fmpq_is_one(&p->formula->nodes[e->left].value);
    if (inverse && function != TP_FUNCTION_TAN) {
      return tp_parser_fail(p, at, "what does %s^-1 mean? Write 1/%s(x), or an inverse function",
                            functions[function], functions[function]);
    }
  } else {
    p->at = mark;
  }
  const long of = argument(p, functions[function]);
  if (of < 0) return -1;
  if (inverse) {
    const tp_formula_node *n = p->formula->nodes + of;
    const bool angle =
        n->kind == TP_FORMULA_NAME && p->vocabulary->is_angle(p->vocabulary->context, n->name);
    function = angle ? TP_FUNCTION_COT : TP_FUNCTION_ATAN;
  }
  const long value = tp_parser_unary(p, TP_FORMULA_CALL, of, (tp_span){at, length});
  if (value < 0) return -1;
  p->formula->nodes[value].function = function;
  if (exponent < 0 || inverse) return value;
  return tp_parser_binary(p, TP_FORMULA_POWER, value, exponent, (tp_span){power_at, used});
}

static int function_named(const front *f) {
  for (int k = 0; k < FUNCTIONS; k++) {
    if (strlen(functions[k]) == f->length && strncmp(functions[k], f->name, f->length) == 0)
      return k;
  }
  return -1;
}

/* No front of the word here is known. */
static long fail_unknown(tp_parser *p, size_t length) {
  const int at = p->at;
  const tp_quote word = tp_quote_of(tp_parser_here(p), length);
  if (tp_ratio_is_not_finite(word.text))
    return tp_parser_fail(p, at, "'%s' is not a finite number", word.text);
  if (p->dialect->functions && strncmp(tp_parser_here(p), "log", 3) == 0)
    return tp_parser_fail(p, at, "write log10 for the decimal logarithm");
  p->at += (int)length;
  tp_parser_skip_blanks(p);
  if (!p->dialect->functions && *tp_parser_here(p) == '(') {
    return tp_parser_fail(p, at,
                          "'%s(…)' is no exact operation; expressions take + - * / ^ and "
                          "parentheses, so write its value as a number",
                          word.text);
  }
  return tp_parser_fail(p, at, "unknown name '%s'; %s", word.text, p->dialect->unknown_name);
}

long tp_parser_word(tp_parser *p, bool as_argument) {
  const int at = p->at;
  front f;
  take_front(&f, p, p->dialect->letters ? TP_NAME_SIZE - 1 : SIZE_MAX);
  const size_t all = f.used, least = p->dialect->products || all == 0 ? 1 : all;
  for (size_t most = all; most >= least; most--) {
    take_front(&f, p, most);
    const int function = p->dialect->functions && !as_argument ? function_named(&f) : -1;
    if (function >= 0) {
      p->at += (int)f.used;
      return application(p, (tp_function)function, at, (int)f.used);
    }
    const long known =
        f.used > 0 ? p->vocabulary->find(p->vocabulary->context, f.name, f.length) : -1;
    if (known < 0) continue;
    p->at += (int)f.used;
    const long node = tp_parser_leaf(p, TP_FORMULA_NAME, (tp_span){at, (int)f.used});
    if (node >= 0) p->formula->nodes[node].name = known;
    return node;
  }
  return fail_unknown(p, all);
}
