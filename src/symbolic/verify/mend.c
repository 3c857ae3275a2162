/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The smallest change that makes a refuted formula an identity.
 *
 * Candidates are changes of the text at one place, so that what is reported is what was read and
 * proven again: a sign turned; a number replaced; an exponent replaced or added; a term multiplied;
 * a name taken for another. The first kind that works is kept, and of that kind the change with the
 * simplest number. The search ends where its share of the budget is spent, and says so. */

#include "verify/mend.h"

#include "derive/field_work.h"
#include "verify/evaluate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 64, NODE_UNITS = 1 };
static const double most_units = 2500000; /* for one claim */
static const double share = 0.6;          /* of the budget; the rest is for proofs */

typedef struct search {
  const tp_question *question;
  tp_claim_result *result;
  arb_t derived; /* the quantity at the claim's values */
  double best;   /* of the change that is kept: the smaller, the simpler */
  bool failed;   /* memory was exhausted */
} search;

/* Room for another candidate: it is read, and enclosed at the claim's values. */
static bool spend(const search *s) {
  const tp_question *q = s->question;
  return tp_field_spend(q->subject->field, NODE_UNITS * (double)(q->printed->count + 10));
}

/* Could the text be an identity? Not if it differs at the claim's values. */
static bool may_be_identity(const char *text, search *s) {
  const tp_question *q = s->question;
  tp_formula formula;
  tp_message ignored;
  tp_status status = tp_subject_read(&formula, text, q->printed->place, q->subject, &ignored);
  s->failed = s->failed || status == TP_OUT_OF_MEMORY;
  if (status != TP_OK) return false;
  arb_t value;
  arb_init(value);
  status = tp_evaluate_ball(value, &formula, q->subject, q->sample, false, BITS, &ignored);
  const bool differs =
      arb_is_finite(value) && arb_is_finite(s->derived) && !arb_overlaps(value, s->derived);
  arb_clear(value);
  tp_formula_clear(&formula);
  s->failed = s->failed || status == TP_OUT_OF_MEMORY;
  return status == TP_OK && !differs;
}

static bool is_identity(const char *text, search *s) {
  const fmpz_mpoly_ctx_struct *ring = s->question->subject->field->ring;
  if (!spend(s) || !may_be_identity(text, s)) return false;
  fmpz_mpoly_q_t difference;
  fmpz_mpoly_q_init(difference, ring);
  const bool zero = tp_mend_difference(difference, &s->failed, text, s->question) &&
                    fmpz_mpoly_q_is_zero(difference, ring);
  fmpz_mpoly_q_clear(difference, ring);
  tp_field_forgive(s->question->subject->field);
  return zero;
}

/* Keep a change if it makes an identity and is simpler than what is kept. Takes `text` over. */
static bool try_change(search *s, char *text, double size, const char *change) {
  if (text == NULL) {
    s->failed = true;
    return false;
  }
  const bool better = (s->result->mend == NULL || size < s->best) && is_identity(text, s);
  if (better) {
    free(s->result->mend);
    free(s->result->change);
    s->result->mend = text;
    s->result->change = strdup(change);
    s->failed = s->failed || s->result->change == NULL;
    s->best = size;
  } else {
    free(text);
  }
  return better;
}

static const tp_formula *printed(const search *s) {
  return s->question->printed;
}

static void turn_signs(search *s) {
  const tp_formula *f = printed(s);
  char change[160], text[60];
  for (long k = 0; k < f->count; k++) {
    const tp_formula_node *n = f->nodes + k;
    if (n->kind == TP_FORMULA_ADD || n->kind == TP_FORMULA_SUBTRACT) {
      const tp_formula_node *right = f->nodes + n->right;
      const char *sign = n->kind == TP_FORMULA_ADD ? "-" : "+";
      snprintf(change, sizeof change, "the sign before %s is %s",
               tp_mend_part(text, sizeof text, printed(s), right->begin, right->end), sign);
      try_change(s, tp_mend_replaced(f, n->at, n->at + n->length, sign), 1, change);
    } else if (n->kind == TP_FORMULA_NEGATE) {
      snprintf(change, sizeof change, "there is no minus before %s",
               tp_mend_part(text, sizeof text, printed(s), n->at + n->length, n->end));
      try_change(s, tp_mend_replaced(f, n->at, n->at + n->length, ""), 1, change);
    }
  }
  try_change(s, tp_mend_replaced(f, 0, 0, "-"), 2, "the sign of the whole is -");
}

typedef void (*root_visitor)(search *s, const fmpq_t root, int begin, int end);

/* Visit the numbers for which the text with the unknown, as `written`, at [begin, end) may be an
 * identity. */
static void solve_for(search *s, int begin, int end, const char *written, root_visitor visit) {
  if (!spend(s)) return;
  fmpq *roots = NULL;
  char *text = tp_mend_replaced(printed(s), begin, end, written);
  const long count = text != NULL ? tp_mend_solve(&roots, text, s->question) : -1;
  free(text);
  tp_field_forgive(s->question->subject->field);
  if (count < 0) s->failed = true;
  for (long k = 0; k < count; k++) {
    visit(s, roots + k, begin, end);
    fmpq_clear(roots + k);
  }
  free(roots);
}

static void keep_number(search *s, const fmpq_t root, int begin, int end) {
  char by[90], change[200], text[60], number[80];
  tp_mend_part(text, sizeof text, printed(s), begin, end);
  const bool decimal = strchr(text, '.') != NULL;
  tp_mend_number(by, sizeof by, root, decimal);
  tp_mend_digits(number, sizeof number, root, decimal);
  snprintf(change, sizeof change, "the number %s at column %d is %s", text,
           tp_formula_place(printed(s), begin).column - printed(s)->place.column + 1, number);
  try_change(s, tp_mend_replaced(printed(s), begin, end, by), tp_mend_simplicity(root), change);
}

static void change_numbers(search *s) {
  const tp_formula *f = printed(s);
  for (long k = 0; k < f->count; k++) {
    const tp_formula_node *n = f->nodes + k;
    if (n->kind == TP_FORMULA_NUMBER) {
      solve_for(s, n->at, n->at + n->length, "(" TP_MEND_UNKNOWN ")", keep_number);
    }
  }
}

static void keep_factor(search *s, const fmpq_t root, int begin, int end) {
  (void)end;
  char number[80], by[100], change[200], text[60];
  const tp_formula *f = printed(s);
  tp_mend_number(number, sizeof number, root, false);
  snprintf(by, sizeof by, "%s*", number);
  int stop = begin;
  for (long k = 0; k < f->count; k++) { /* the longest product that begins here */
    const tp_formula_node *n = f->nodes + k;
    if (n->begin == begin && n->end > stop && n->kind != TP_FORMULA_ADD &&
        n->kind != TP_FORMULA_SUBTRACT) {
      stop = n->end;
    }
  }
  tp_mend_part(text, sizeof text, printed(s), begin, stop);
  if (fmpq_is_zero(root)) {
    snprintf(change, sizeof change, "the term %s is not there", text);
  } else {
    snprintf(change, sizeof change, "%s is to be multiplied by %s", text, number);
  }
  try_change(s, tp_mend_replaced(f, begin, begin, by), tp_mend_simplicity(root), change);
}

/* Multiply each term of a sum, and the whole. */
static void multiply_terms(search *s) {
  const tp_formula *f = printed(s);
  for (long k = 0; k < f->count; k++) {
    const tp_formula_node *n = f->nodes + k;
    if (n->kind != TP_FORMULA_ADD && n->kind != TP_FORMULA_SUBTRACT) continue;
    const tp_formula_node *operands[2] = {f->nodes + n->left, f->nodes + n->right};
    for (int j = 0; j < 2; j++) {
      const bool sum =
          operands[j]->kind == TP_FORMULA_ADD || operands[j]->kind == TP_FORMULA_SUBTRACT;
      if (sum && f->text[operands[j]->begin] != '(') continue; /* its first term has its turn */
      solve_for(s, operands[j]->begin, operands[j]->begin, "(" TP_MEND_UNKNOWN ")*", keep_factor);
    }
  }
  solve_for(s, 0, 0, "(" TP_MEND_UNKNOWN ")*", keep_factor);
}

static void try_exponent(search *s, int begin, int end, const char *exponent, double size,
                         const char *of) {
  char change[200], by[24];
  snprintf(change, sizeof change, "the exponent of %s is %s", of, exponent);
  snprintf(by, sizeof by, "^%s", exponent);
  try_change(s, tp_mend_replaced(printed(s), begin, end, by), size, change);
}

/* Replace exponents, and give one to what has none. */
static void change_exponents(search *s) {
  static const char *const exponents[] = {"1", "2", "3", "4",  "5",  "6",    "7",
                                          "8", "9", "0", "-1", "-2", "(1/2)"};
  const tp_formula *f = printed(s);
  for (long k = 0; k < f->count; k++) {
    const tp_formula_node *n = f->nodes + k;
    char of[60];
    if (n->kind != TP_FORMULA_POWER && n->kind != TP_FORMULA_NAME && n->kind != TP_FORMULA_CALL &&
        f->text[n->begin] != '(') {
      continue;
    }
    const bool power = n->kind == TP_FORMULA_POWER;
    bool is_base = false;
    for (long j = k + 1; j < f->count; j++) {
      is_base = is_base || (f->nodes[j].kind == TP_FORMULA_POWER && f->nodes[j].left == k);
    }
    if (is_base) continue;
    const int base_end = power ? f->nodes[n->left].end : n->end;
    const bool inside = power && f->nodes[n->right].end < base_end; /* sin^2 x */
    tp_mend_part(of, sizeof of, printed(s), n->begin, base_end);
    for (size_t j = 0; j < sizeof exponents / sizeof exponents[0]; j++) {
      try_exponent(s, inside ? n->at : base_end, inside ? f->nodes[n->right].end : n->end,
                   exponents[j], (double)j, of);
    }
  }
}

static void try_name(search *s, const tp_formula_node *n, const char *name, double size) {
  enum { MORE = 100 }; /* what is said besides the name */
  const size_t room = strlen(name) + MORE;
  char *by = malloc(room), *change = malloc(room), text[60];
  if (by == NULL || change == NULL) {
    s->failed = true;
  } else {
    snprintf(by, room, "(%s)", name);
    snprintf(change, room, "%s is %s",
             tp_mend_part(text, sizeof text, printed(s), n->at, n->at + n->length), name);
    try_change(s, tp_mend_replaced(printed(s), n->begin, n->end, by), size, change);
  }
  free(by);
  free(change);
}

/* Take one name for another that the formulas use. */
static void change_names(search *s) {
  const tp_formula *f = printed(s);
  const tp_subject *subject = s->question->subject;
  for (long k = 0; k < f->count; k++) {
    const tp_formula_node *n = f->nodes + k;
    if (n->kind != TP_FORMULA_NAME) continue;
    for (long other = 0; other < subject->name_count; other++) {
      const tp_name *name = subject->names + other;
      if (other == n->name || name->kind == TP_NAME_DIRECTION || name->rule != NULL) continue;
      if (strcmp(name->text, TP_MEND_UNKNOWN) == 0) continue;
      try_name(s, n, name->text, (double)other);
    }
  }
}

/* Try the kinds of change in turn, within a budget of the search's own. */
static tp_status find(search *s) {
  static void (*const kinds[])(search *) = {turn_signs, change_numbers, change_exponents,
                                            multiply_terms, change_names};
  const tp_question *q = s->question;
  tp_field_work *work = q->subject->field->work;
  const double whole = work->budget;
  const double half = fmax(0, share * whole - work->spent) / 2;
  work->budget = work->spent + fmin(half, most_units);
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    if (s->result->mend == NULL) kinds[k](s);
  }
  const bool spent = tp_field_problem(q->subject->field) != NULL;
  work->budget = whole;
  tp_field_forgive(q->subject->field);
  if (s->failed) return tp_fail_memory(q->message, "a claim");
  if (!spent || s->result->mend != NULL || s->result->condition != NULL) return TP_OK;
  s->result->condition = strdup("the search for a correction was stopped: the formula is long");
  return s->result->condition != NULL ? TP_OK : tp_fail_memory(q->message, "a claim");
}

tp_status tp_mend_find(tp_claim_result *result, const tp_question *q) {
  search s = {.question = q, .result = result};
  tp_name *x = tp_subject_add_name(q->subject, TP_MEND_UNKNOWN, TP_NAME_FORMULA);
  if (x == NULL) return tp_fail_memory(q->message, "a claim");
  fmpz_mpoly_q_gen(x->value, q->subject->mend, q->subject->field->ring);
  arb_init(s.derived);
  const tp_status status =
      tp_evaluate_ball(s.derived, q->quantity, q->subject, q->sample, false, BITS, q->message);
  const tp_status found = status == TP_OK ? find(&s) : status;
  arb_clear(s.derived);
  return found;
}
