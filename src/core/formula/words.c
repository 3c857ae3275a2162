/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words of a formula: the longest front of the letters that is a known name or a function, by a
 * look at every front where factors may stand side by side, else the whole word alone. */

#include "formula/parser.h"

#include "common/outside.h"
#include "formula/spelling.h"
#include "number/ratio.h"

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

const char *tp_function_name(tp_function function) {
  return functions[function];
}

static int function_named(const front *f) {
  for (int k = 0; k < FUNCTIONS; k++) {
    if (strlen(functions[k]) == f->length && strncmp(functions[k], f->name, f->length) == 0)
      return k;
  }
  return -1;
}

/* No front of the word here is known. */
static bool fail_unknown(tp_parser *p, size_t length) {
  const int at = p->at;
  const tp_quote word = tp_quote_of(tp_parser_here(p), length);
  const bool logarithm = p->dialect->functions && strncmp(tp_parser_here(p), "log", 3) == 0;
  p->at += (int)length;
  tp_parser_skip_blanks(p);
  if (tp_ratio_is_not_finite(word.text)) {
    tp_parser_fail(p, at, "'%s' is not a finite number", word.text);
  } else if (logarithm) {
    tp_parser_fail(p, at, "write log10 for the decimal logarithm");
  } else if (!p->dialect->functions && *tp_parser_here(p) == '(') {
    tp_parser_fail(
        p, at,
        "'%s(…)' is not an exact operation; expressions take + - * / ^ and parentheses, so "
        "write its value as a number",
        word.text);
  } else {
    tp_parser_fail(p, at, "unknown name '%s'; %s", word.text, p->dialect->unknown_name);
  }
  return false;
}

bool tp_parser_word(tp_parser *p, tp_word *word, bool as_argument) {
  front f;
  take_front(&f, p, p->dialect->letters ? TP_NAME_SIZE - 1 : SIZE_MAX);
  const size_t all = f.used, least = p->dialect->products || all == 0 ? 1 : all;
  for (size_t most = all; most >= least; most--) {
    take_front(&f, p, most);
    const int function = p->dialect->functions && !as_argument ? function_named(&f) : -1;
    const bool looked_up = function < 0 && f.used > 0;
    const long name =
        looked_up ? p->vocabulary->find(p->vocabulary->context, f.name, f.length) : -1;
    if (function < 0 && name < 0) continue;
    *word = (tp_word){function >= 0, (tp_function)(function >= 0 ? function : 0), name,
                      (tp_span){p->at, (int)f.used}};
    p->at += (int)f.used;
    return true;
  }
  return fail_unknown(p, all);
}
