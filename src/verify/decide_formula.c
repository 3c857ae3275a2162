/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Verdicts on formulas.
 *
 * Where both sides are rational in the symbols, sines and cosines the claim is an identity if and
 * only if the numerator of the difference, reduced by sin^2 + cos^2 = 1 for every angle, is the
 * zero polynomial: proven or refuted. Otherwise both sides are enclosed at many rational points:
 * two enclosures that do not meet refute the claim; if all meet it agrees to as many digits as they
 * are narrow, and is not called proven. */

#include "verify/decide.h"

#include "derive/field_work.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 24, BITS = 256 };

tp_status tp_decide_difference(fmpz_mpoly_q_t difference, fmpz_mpoly_q_struct *derived,
                               bool *rational, bool *tangents, const tp_question *q) {
  tp_subject *s = q->subject;
  const tp_field *field = s->field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t value;
  fmpz_mpoly_q_init(value, ring);
  bool both = false;
  *rational = *tangents = false;
  tp_status status = tp_evaluate_tangent(value, rational, q->quantity, s, q->message);
  if (status == TP_OK && *rational) {
    status = tp_evaluate_tangent(difference, &both, q->printed, s, q->message);
  }
  *tangents = both;
  if (status == TP_OK && !both) {
    status = tp_evaluate_field(value, rational, q->quantity, s, q->message);
    if (status == TP_OK) status = tp_evaluate_field(difference, &both, q->printed, s, q->message);
  }
  *rational = *rational && both;
  if (status == TP_OK && *rational) {
    tp_field_sub(difference, difference, value, field);
    tp_subject_reduce(difference, s);
    if (derived != NULL) fmpz_mpoly_q_swap(derived, value, field->ring);
    const char *problem = tp_field_problem(field);
    if (problem != NULL) {
      status = tp_formula_fail(q->printed, tp_formula_root(q->printed), q->message, problem);
    }
  }
  fmpz_mpoly_q_clear(value, ring);
  return status;
}

/* Both sides at a sample. */
static tp_status both_sides(arb_t printed, arb_t derived, const tp_question *q,
                            const tp_sample *sample) {
  tp_status status =
      tp_evaluate_ball(printed, q->printed, q->subject, sample, false, BITS, q->message);
  if (status != TP_OK) return status;
  return tp_evaluate_ball(derived, q->quantity, q->subject, sample, false, BITS, q->message);
}

static tp_status keep_values(tp_claim_result *result, const arb_t printed, const arb_t derived,
                             const tp_question *q, const tp_sample *sample) {
  char text[600];
  int *used = calloc((size_t)sample->count, sizeof *used);
  if (used == NULL) return tp_fail_memory(q->message, "a claim");
  tp_status status = tp_evaluate_used(used, q->printed, q->subject, q->message);
  if (status == TP_OK) status = tp_evaluate_used(used, q->quantity, q->subject, q->message);
  tp_sample_text(text, sizeof text, sample, q->subject, used);
  free(used);
  if (status != TP_OK) return status;
  result->has_values = true;
  result->printed_value = tp_ball_bounded(printed);
  result->computed = tp_ball_bounded(derived);
  result->values = strdup(text);
  return result->values != NULL ? TP_OK : tp_fail_memory(q->message, "a claim");
}

/* Both sides at the claim's own values, or, where they are equal there or undefined, at the first
 * point where they are not. */
static tp_status find_witness(tp_claim_result *result, const tp_question *q) {
  arb_t printed, derived;
  arb_init(printed);
  arb_init(derived);
  tp_status status = TP_OK;
  for (unsigned k = 0; k <= POINTS && status == TP_OK && !result->has_values; k++) {
    tp_sample sample;
    if (!tp_sample_init_copy(&sample, q->sample)) {
      status = tp_fail_memory(q->message, "a claim");
      break;
    }
    if (k > 0) tp_sample_scatter(&sample, q->subject, k);
    status = both_sides(printed, derived, q, &sample);
    if (status == TP_OK && arb_is_finite(printed) && arb_is_finite(derived) &&
        !arb_overlaps(printed, derived)) {
      status = keep_values(result, printed, derived, q, &sample);
    }
    tp_sample_clear(&sample);
  }
  arb_clear(printed);
  arb_clear(derived);
  return status;
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
    digits = BITS * 0.301;
  } else if (!mag_is_zero(scale)) {
    digits = -(mag_get_d_log2_approx(size) - mag_get_d_log2_approx(scale)) * 0.30102999566;
  }
  mag_clear(size);
  mag_clear(scale);
  arb_clear(gap);
  return digits > 1 ? (int)digits : 1;
}

/* At points about the claim's values. */
static tp_status decide_at_points(tp_claim_result *result, const tp_question *q) {
  arb_t printed, derived;
  arb_init(printed);
  arb_init(derived);
  tp_status status = TP_OK;
  int digits = BITS;
  for (unsigned k = 0; k < POINTS && status == TP_OK && !result->has_values; k++) {
    tp_sample sample;
    if (!tp_sample_init_copy(&sample, q->sample)) {
      status = tp_fail_memory(q->message, "a claim");
      break;
    }
    if (k > 0) tp_sample_scatter(&sample, q->subject, k);
    status = both_sides(printed, derived, q, &sample);
    if (status == TP_OK && arb_is_finite(printed) && arb_is_finite(derived)) {
      result->points++;
      const int own = digits_of(printed, derived);
      digits = own < digits ? own : digits;
      if (!arb_overlaps(printed, derived)) {
        status = keep_values(result, printed, derived, q, &sample);
      }
    }
    tp_sample_clear(&sample);
  }
  arb_clear(printed);
  arb_clear(derived);
  if (status != TP_OK) return status;
  if (result->has_values) {
    result->verdict = TP_VERDICT_REFUTED;
    result->points = 0;
  } else {
    result->verdict = result->points > 0 ? TP_VERDICT_AGREES : TP_VERDICT_UNDECIDED;
    result->digits = result->points > 0 ? digits : 0;
  }
  return TP_OK;
}

static tp_status decide_identity(tp_claim_result *result, const fmpz_mpoly_q_t difference,
                                 const fmpz_mpoly_q_t derived, const tp_question *q) {
  tp_status status = tp_decide_write(&result->derived, derived, q);
  if (status != TP_OK) return status;
  if (fmpz_mpoly_q_is_zero(difference, q->subject->field->ring)) {
    result->verdict = TP_VERDICT_PROVEN;
    return TP_OK;
  }
  result->verdict = TP_VERDICT_REFUTED;
  status = tp_decide_write(&result->difference, difference, q);
  if (status == TP_OK) status = find_witness(result, q);
  return status == TP_OK ? tp_mend_find(result, q) : status;
}

tp_status tp_decide_formula(tp_claim_result *result, const tp_question *q) {
  const fmpz_mpoly_ctx_struct *ring = q->subject->field->ring;
  fmpz_mpoly_q_t difference, derived;
  bool rational = false;
  fmpz_mpoly_q_init(difference, ring);
  fmpz_mpoly_q_init(derived, ring);
  tp_status status = tp_decide_difference(difference, derived, &rational, &result->is_tangent, q);
  if (status == TP_OK) {
    status =
        rational ? decide_identity(result, difference, derived, q) : decide_at_points(result, q);
  }
  fmpz_mpoly_q_clear(difference, ring);
  fmpz_mpoly_q_clear(derived, ring);
  return status;
}
