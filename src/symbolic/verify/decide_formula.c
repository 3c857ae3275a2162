/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Verdicts on formulas.
 *
 * Where both sides are rational in the symbols, sines and cosines the claim is an identity if and
 * only if the numerator of the difference, reduced by sin^2 + cos^2 = 1 for every angle, is the
 * zero polynomial. Roots of squares and magnitudes are so in branches, by the signs of what they
 * are taken of: the claim is proven if it is an identity in all, refuted if it is one in none.
 * Angles are compared by their tangents, and their ranges must not reach to a multiple of 180
 * degrees. What the printed formula divides by must not vanish within the domain where the quantity
 * has a value. All else is left to points of the domain. */

#include "verify/decide.h"

#include "derive/field_work.h"
#include "verify/angle_range.h"
#include "verify/mend.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the branches of a claim say. */
typedef struct survey {
  tp_branches branches;
  fmpz_mpoly_q_t difference, derived; /* in the branch of the claim's values */
  bool tangents;
  bool rational;     /* in all branches */
  long equal, other; /* branches in which it is an identity, and in which not */
  bool holds_here;   /* it is one in the branch of the claim's values */
  char *where;       /* that branch in words; NULL: there is one alone */
} survey;

static void survey_init(survey *v, const tp_question *q) {
  memset(v, 0, sizeof *v);
  tp_branches_init(&v->branches, q->subject, q->sample);
  v->branches.gathers_divisors = true;
  v->rational = true;
  fmpz_mpoly_q_init(v->difference, q->subject->field->ring);
  fmpz_mpoly_q_init(v->derived, q->subject->field->ring);
}

static void survey_clear(survey *v, const tp_question *q) {
  tp_branches_use(NULL, q->subject);
  tp_branches_clear(&v->branches);
  fmpz_mpoly_q_clear(v->difference, q->subject->field->ring);
  fmpz_mpoly_q_clear(v->derived, q->subject->field->ring);
  free(v->where);
}

/* "a - 1 >= 0, b - a <= 0" for the signs of the branch; NULL where it has none. */
static tp_status name_branch(char **text, const tp_branches *b, const tp_question *q) {
  char *all = NULL;
  tp_status status = TP_OK;
  for (long k = 0; k < b->count && status == TP_OK; k++) {
    char *one = NULL;
    status = tp_question_write(&one, b->items[k].of, q);
    const size_t size = (all != NULL ? strlen(all) : 0) + (one != NULL ? strlen(one) : 0) + 16;
    char *longer = status == TP_OK ? malloc(size) : NULL;
    if (status == TP_OK && longer == NULL) status = tp_fail_memory(q->message, "a claim");
    if (longer != NULL) {
      snprintf(longer, size, "%s%s%s %s 0", all != NULL ? all : "", all != NULL ? ", " : "", one,
               b->items[k].sign > 0 ? ">=" : "<=");
    }
    free(one);
    free(all);
    all = longer;
  }
  *text = all;
  return status;
}

/* One branch. What cannot be formed in it, as where something is divided by zero, is no identity
 * there, unless it is the budget that is spent. */
static tp_status survey_branch(survey *v, bool *formed, bool first, const tp_question *q) {
  const fmpz_mpoly_ctx_struct *ring = q->subject->field->ring;
  fmpz_mpoly_q_t difference, derived;
  fmpz_mpoly_q_init(difference, ring);
  fmpz_mpoly_q_init(derived, ring);
  bool rational = false;
  tp_branches_use(&v->branches, q->subject);
  tp_status status = tp_question_difference(difference, derived, &rational, &v->tangents, q);
  *formed = status == TP_OK;
  if (status == TP_OK && !rational) {
    v->rational = false;
  } else if (status == TP_OK) {
    const bool equal = fmpz_mpoly_q_is_zero(difference, ring) != 0;
    v->equal += equal;
    v->other += !equal;
    if (first) {
      v->holds_here = equal;
      fmpz_mpoly_q_swap(v->difference, difference, ring);
      fmpz_mpoly_q_swap(v->derived, derived, ring);
      status = name_branch(&v->where, &v->branches, q);
    }
  }
  fmpz_mpoly_q_clear(difference, ring);
  fmpz_mpoly_q_clear(derived, ring);
  return status;
}

static tp_status survey_all(survey *v, const tp_question *q) {
  bool any = false;
  tp_status status = TP_OK;
  for (long k = 0; k < TP_MOST_BRANCHES; k++) {
    bool formed = false;
    status = survey_branch(v, &formed, k == 0, q);
    any = any || formed;
    const bool apart = status == TP_OK || (status == TP_BAD_INPUT && !formed &&
                                           tp_field_problem(q->subject->field) == NULL);
    if (!apart || !v->rational) return status;
    v->other += !formed;
    if (!tp_branches_next(&v->branches)) return any ? TP_OK : status;
  }
  v->branches.too_many = true;
  return any ? TP_OK : status;
}

/* Can what the printed formula divides by vanish where the quantity has a value? The factors that
 * it shares with the quantity's denominator are left out. `*text`: the first that can, else NULL.
 */
static tp_status find_vanishing(char **text, const survey *v, const tp_question *q) {
  const tp_field *field = q->subject->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  tp_status status = TP_OK;
  fmpz_mpoly_q_t rest, below;
  fmpz_mpoly_q_init(rest, ring);
  fmpz_mpoly_q_init(below, ring);
  for (long k = 0; k < v->branches.divisor_count && *text == NULL && status == TP_OK; k++) {
    fmpz_mpoly_set(fmpz_mpoly_q_numref(rest), fmpz_mpoly_q_numref(v->branches.divisors[k]), ring);
    fmpz_mpoly_one(fmpz_mpoly_q_denref(rest), ring);
    fmpz_mpoly_set(fmpz_mpoly_q_numref(below), fmpz_mpoly_q_denref(v->derived), ring);
    bool shared = true;
    while (shared && tp_field_problem(field) == NULL) { /* rest = rest / gcd(rest, below) */
      const slong before = fmpz_mpoly_total_degree_si(fmpz_mpoly_q_numref(rest), ring);
      tp_field_div(rest, rest, below, field);
      fmpz_mpoly_one(fmpz_mpoly_q_denref(rest), ring);
      shared = fmpz_mpoly_total_degree_si(fmpz_mpoly_q_numref(rest), ring) < before;
    }
    if (tp_domain_sign(rest, q->subject->domain, true) == 0)
      status = tp_question_write(text, rest, q);
  }
  fmpz_mpoly_q_clear(rest, ring);
  fmpz_mpoly_q_clear(below, ring);
  return status;
}

/* A text before and after another, as the condition. */
static tp_status set_condition(tp_claim_result *result, const tp_question *q, const char *before,
                               const char *text, const char *after) {
  const size_t size = strlen(before) + strlen(text) + strlen(after) + 1;
  char *all = malloc(size);
  if (all == NULL) return tp_fail_memory(q->message, "a claim");
  snprintf(all, size, "%s%s%s", before, text, after);
  free(result->condition);
  result->condition = all;
  return TP_OK;
}

/* An identity in every branch is proven unless its angles or its divisors keep it from being so. */
static tp_status decide_identity(tp_claim_result *result, const survey *v, const tp_question *q) {
  char *vanishing = NULL;
  if (v->tangents && !tp_angles_in_reach(q)) {
    const tp_status status = tp_decide_at_points(result, q, &v->branches);
    if (status != TP_OK || result->condition != NULL) return status;
    return set_condition(result, q, "the tangents of these angles are equal", "",
                         ", so they differ by multiples of 180 degrees");
  }
  tp_status status = find_vanishing(&vanishing, v, q);
  result->verdict = TP_VERDICT_PROVEN;
  if (status == TP_OK && vanishing != NULL) {
    status = tp_decide_at_points(result, q, &v->branches);
    if (status == TP_OK) {
      status =
          set_condition(result, q,
                        result->verdict == TP_VERDICT_UNDECIDED
                            ? "the printed formula has no value at the values of the claim: an "
                              "identity except where "
                            : "an identity except where ",
                        vanishing, " = 0");
    }
  }
  free(vanishing);
  return status;
}

static tp_status refute(tp_claim_result *result, const survey *v, const tp_question *q) {
  result->verdict = TP_VERDICT_REFUTED;
  tp_status status = tp_question_write(&result->difference, v->difference, q);
  if (status == TP_OK) status = tp_decide_witness(result, q);
  tp_branches_use(NULL, q->subject);
  return status == TP_OK ? tp_mend_find(result, q) : status;
}

/* An identity in some branches: points tell whether the others are within the domain. */
static tp_status decide_parts(tp_claim_result *result, const survey *v, const tp_question *q) {
  const tp_status status = tp_decide_at_points(result, q, &v->branches);
  if (status != TP_OK || v->where == NULL) return status;
  const char *before = v->holds_here ? "it holds where " : "it does not hold where ";
  if (result->condition == NULL) return set_condition(result, q, before, v->where, "");
  const size_t size = strlen(before) + strlen(v->where) + 1;
  char *start = malloc(size);
  if (start == NULL) return tp_fail_memory(q->message, "a claim");
  snprintf(start, size, "%s%s", before, v->where);
  const tp_status joined =
      set_condition(result, q, start, ", as at the values of the claim; ", result->condition);
  free(start);
  return joined;
}

tp_status tp_decide_formula(tp_claim_result *result, const tp_question *q) {
  survey v;
  survey_init(&v, q);
  tp_status status = survey_all(&v, q);
  result->of_tangents = v.rational && v.tangents;
  if (status == TP_OK && v.rational && v.equal + v.other > 0) {
    status = tp_question_write(&result->computed, v.derived, q);
  }
  if (status != TP_OK) {
    survey_clear(&v, q);
    return status;
  }
  if (!v.rational || v.branches.too_many) {
    status = tp_decide_at_points(result, q, &v.branches);
  } else if (v.other == 0) {
    status = decide_identity(result, &v, q);
  } else if (v.equal == 0) {
    status = refute(result, &v, q);
  } else {
    status = decide_parts(result, &v, q);
  }
  survey_clear(&v, q);
  return status;
}
