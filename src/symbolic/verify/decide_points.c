/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Verdicts from points.
 *
 * Both sides are enclosed at the claim's values, at points about them, at points from one end of
 * the domain to the other, and on both sides of every zero of what a root or a magnitude is taken
 * of. Two enclosures that do not meet refute the claim, at the claim's values and about them, or
 * anywhere in a domain that the claims file states; further away in one that it does not state the
 * verdict is about the neighbourhood alone, and says where the claim fails. If all meet it agrees
 * to as many digits as they are narrow, which is no proof. A point at which a derived direction is
 * in another quadrant than at the claim's values is left out. */

#include "verify/decide.h"

#include "derive/field_work.h"
#include "number/ball.h"
#include "verify/evaluate.h"
#include "verify/points.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 256 }; /* 77 digits: both sides agree to fewer unless they are one */

/* Both sides at a sample. */
static tp_status both_sides(arb_t printed, arb_t derived, const tp_question *q,
                            const tp_claim_sample *sample) {
  tp_status status =
      tp_evaluate_ball(printed, q->printed, q->subject, sample, false, BITS, q->message);
  if (status != TP_OK) return status;
  return tp_evaluate_ball(derived, q->quantity, q->subject, sample, false, BITS, q->message);
}

static tp_status values_text(char **out, const tp_question *q, const tp_claim_sample *sample) {
  char text[600];
  int *used = calloc((size_t)sample->count, sizeof *used);
  if (used == NULL) return tp_fail_memory(q->message, "a claim");
  tp_status status = tp_subject_used(used, q->printed, q->subject, q->message);
  if (status == TP_OK) status = tp_subject_used(used, q->quantity, q->subject, q->message);
  tp_sample_text(text, sizeof text, sample, q->subject, used);
  free(used);
  if (status != TP_OK) return status;
  *out = strdup(text);
  return *out != NULL ? TP_OK : tp_fail_memory(q->message, "a claim");
}

static tp_status keep_values(tp_claim_result *result, const arb_t printed, const arb_t derived,
                             const tp_question *q, const tp_claim_sample *sample) {
  result->has_values = true;
  result->printed_there = tp_ball_bounded(printed);
  result->computed_there = tp_ball_bounded(derived);
  return values_text(&result->at, q, sample);
}

/* Decimal digits to which two enclosures that meet agree. */
static int digits_of(const arb_t printed, const arb_t derived) {
  arb_t gap;
  arb_init(gap);
  arb_sub(gap, printed, derived, BITS);
  mag_t size, scale;
  mag_init(size);
  mag_init(scale);
  arb_get_mag(size, gap);
  arb_get_mag_lower(scale, derived);
  double digits = 1; /* of zero itself */
  if (mag_is_zero(size)) {
    digits = tp_bits_digits(BITS);
  } else if (!mag_is_zero(scale)) {
    digits = -tp_bits_digits(mag_get_d_log2_approx(size) - mag_get_d_log2_approx(scale));
  }
  mag_clear(size);
  mag_clear(scale);
  arb_clear(gap);
  return digits > 1 ? (int)digits : 1;
}

/* What the points have said so far. */
typedef struct tally {
  int points, digits;
  int without;     /* points at which one side alone has a value */
  bool own;        /* the claim's own values are one of the points */
  bool undefined;  /* the printed formula has no value there, but the quantity has */
  bool differs;    /* values are kept */
  char *elsewhere; /* values far from the claim's at which it differs; NULL: none are known */
  tp_claim_result *result;
} tally;

static tp_status count_point(tally *t, const tp_question *q, const tp_claim_sample *sample,
                             bool own, bool counts) {
  arb_t printed, derived;
  arb_init(printed);
  arb_init(derived);
  tp_status status = both_sides(printed, derived, q, sample);
  const bool here = arb_is_finite(printed), there = arb_is_finite(derived);
  if (status == TP_OK && here && there && !counts && !arb_overlaps(printed, derived)) {
    if (t->elsewhere == NULL) status = values_text(&t->elsewhere, q, sample);
  } else if (status == TP_OK && here && there) {
    t->points++;
    const int digits = digits_of(printed, derived);
    t->digits = digits < t->digits ? digits : t->digits;
    t->differs = !arb_overlaps(printed, derived);
    if (t->differs) status = keep_values(t->result, printed, derived, q, sample);
  } else if (here != there) {
    t->without++;
    t->undefined = t->undefined || (own && there);
  }
  arb_clear(printed);
  arb_clear(derived);
  return status;
}

/* Go through the points until one tells. */
static tp_status visit(tally *t, const tp_question *q, const tp_branches *branches) {
  tp_points points;
  tp_status status = tp_points_init(&points, q, branches);
  if (status != TP_OK) return status;
  tp_claim_sample sample = {0};
  bool own = true;
  while (status == TP_OK && !t->differs && tp_points_next(&sample, &points)) {
    const bool counts = points.at <= TP_DOMAIN_NEAR || q->subject->domain->bounds_count > 0;
    status = count_point(t, q, &sample, own, counts);
    own = false;
    tp_sample_clear(&sample);
  }
  if (status == TP_OK && points.failed) status = tp_fail_memory(q->message, "a claim");
  if (status == TP_OK && tp_field_problem(q->subject->field) != NULL) {
    status = tp_formula_fail(q->printed, tp_formula_root(q->printed), q->message,
                             tp_field_problem(q->subject->field));
  }
  tp_points_clear(&points);
  return status;
}

static tp_status add_condition(tp_claim_result *result, const tp_question *q, const char *text) {
  if (result->condition != NULL) return TP_OK;
  result->condition = strdup(text);
  return result->condition != NULL ? TP_OK : tp_fail_memory(q->message, "a claim");
}

tp_status tp_decide_at_points(tp_claim_result *result, const tp_question *q,
                              const tp_branches *branches) {
  tally t = {.digits = BITS, .result = result};
  tp_status status = visit(&t, q, branches);
  if (status == TP_OK && t.elsewhere != NULL && !t.differs) {
    char text[700];
    snprintf(text, sizeof text, "about the values of the claim alone: it fails at %s", t.elsewhere);
    status = add_condition(result, q, text);
  }
  free(t.elsewhere);
  if (status != TP_OK) return status;
  if (t.differs) {
    result->verdict = TP_VERDICT_REFUTED;
    return TP_OK;
  }
  result->verdict = t.points > 0 && !t.undefined ? TP_VERDICT_AGREES : TP_VERDICT_UNDECIDED;
  if (t.undefined) {
    return add_condition(result, q, "the printed formula has no value at the values of the claim");
  }
  result->points = t.points;
  result->digits = t.points > 0 ? t.digits : 0;
  if (t.without == 0) return TP_OK;
  char text[80];
  snprintf(text, sizeof text, "one side has no value at %d further points", t.without);
  return add_condition(result, q, text);
}

tp_status tp_decide_witness(tp_claim_result *result, const tp_question *q) {
  tally t = {.digits = BITS, .result = result};
  const tp_status status = visit(&t, q, NULL);
  free(t.elsewhere);
  return status;
}
