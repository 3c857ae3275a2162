/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Factor at which the margin vanishes by Brent's method in doubles, refined by secants of limit
 * minus tilt, then enclosed between a factor proven to hold and one proven not to
 * (docs/mechanics.md section 6, strength reduction). */

#include "strength_reduction/reduction.h"

#include "limit/program.h"
#include "number/ball.h"
#include "number/root.h"
#include "strength_reduction/reduced.h"

#include <math.h>

/* Factors tried: beyond these, strength does not matter. */
static const double least_factor = 1e-6, most_factor = 1e6;

static bool margin_at(double *margin, void *context, double log_factor) {
  *margin = tp_reduced_margin(context, log_factor);
  return true;
}

/* The zero of the margin between two factors, to so few bits that they do not tell on which way it
 * was come upon. */
static bool search(arf_t factor, tp_reduced *r, double low, double high) {
  enum { MOST_PROGRAMS = 200, BITS = 48 };
  static const double width = 4e-16;
  const double least = log(low), most = log(high);
  const tp_root_end weakest = {most, tp_reduced_margin(r, most)};
  const tp_root_end strongest = {least, tp_reduced_margin(r, least)};
  const tp_root_search by = {
      .value = margin_at, .context = r, .width = width, .most = MOST_PROGRAMS};
  tp_root root;
  if (!(strongest.value > 0 && weakest.value < 0)) return false;
  if (!tp_root_find(&root, &by, strongest, weakest)) return false;
  arf_set_d(factor, exp(root.low + (root.high - root.low) / 2));
  arf_set_round(factor, factor, BITS, ARF_RND_NEAR);
  return true;
}

/* From doubles to 10^-digits of the factor by secants of limit less tilt, each limit found anew: it
 * has no derivative, as Newton's method of arb_calc would want it. Search alone: the proof comes
 * after it. */
static tp_limit_outcome refine(arf_t factor, tp_reduced *r, int digits) {
  enum { MOST_STEPS = 64 };
  const long bits = r->question->judge.bits;
  const slong enough = -(slong)tp_digits_bits(digits);
  arf_t step, value, value_before, slope;
  tp_reduced_limit at;
  arf_init(step);
  arf_init(value);
  arf_init(value_before);
  arf_init(slope);
  arb_init(at.degrees);
  arf_mul_2exp_si(step, factor, -30);
  tp_limit_outcome outcome = TP_LIMIT_PROVEN;
  for (int k = 0; k < MOST_STEPS && outcome == TP_LIMIT_PROVEN; k++) {
    outcome = tp_reduced_find(&at, r, factor);
    if (!arb_is_finite(at.degrees)) break;
    arf_set(value_before, value);
    arf_sub(value, arb_midref(at.degrees), arb_midref(r->degrees), bits, ARF_RND_NEAR);
    if (k > 0) { /* the next step is - value (last step) / (value - value_before) */
      arf_sub(slope, value, value_before, bits, ARF_RND_NEAR);
      if (arf_is_zero(slope)) break;
      arf_mul(step, step, value, bits, ARF_RND_NEAR);
      arf_div(step, step, slope, bits, ARF_RND_NEAR);
      arf_neg(step, step);
    }
    if (arf_is_zero(step) ||
        arf_cmpabs_2exp_si(step, arf_abs_bound_lt_2exp_si(factor) + enough) < 0)
      break;
    arf_add(factor, factor, step, bits, ARF_RND_NEAR);
  }
  arf_clear(step);
  arf_clear(value);
  arf_clear(value_before);
  arf_clear(slope);
  arb_clear(at.degrees);
  return outcome;
}

/* Is it held at the tilt with its strength divided by the factor? With the motion at the limit that
 * it then has, which may tell. */
static tp_limit_outcome prove_held(bool *held, tp_reduction *reduction, tp_reduced *r,
                                   const arf_t factor) {
  const bool settled = r->question->judge.settled; /* then what it takes for zero is no proof */
  tp_reduced_limit at;
  arb_init(at.degrees);
  tp_limit_outcome outcome = TP_LIMIT_OPEN;
  int side = 0;
  if (!settled) {
    outcome = tp_reduced_find(&at, r, factor);
    side = outcome == TP_LIMIT_PROVEN && tp_reduced_holds_below(&at, r) ? 1 : 0;
  }
  if (side == 0 && outcome != TP_LIMIT_OUT_OF_MEMORY && outcome != TP_LIMIT_FAILED) {
    outcome = tp_reduced_side(&side, NULL, r, factor, 1);
    if (settled && outcome == TP_LIMIT_PROVEN && side > 0) {
      outcome = tp_reduced_find(&at, r, factor);
      if (outcome == TP_LIMIT_OPEN) outcome = TP_LIMIT_PROVEN;
    }
  }
  *held = outcome == TP_LIMIT_PROVEN && side > 0;
  if (*held) reduction->has_motion = at.has_motion;
  if (*held && at.has_motion) reduction->motion = at.motion;
  arb_clear(at.degrees);
  return outcome;
}

/* Is the factor within 2^-wanted of its size of the estimate? Proven at both ends. */
static tp_limit_outcome prove_about(tp_reduction *reduction, bool *proven, tp_reduced *r,
                                    const arf_t estimate, slong wanted) {
  const long bits = r->question->judge.bits;
  arf_t width, low, high;
  tp_reduced_loss loss = {.known = false};
  int side = 0;
  arf_init(width);
  arf_init(low);
  arf_init(high);
  arf_mul_2exp_si(width, estimate, -wanted);
  arf_sub(low, estimate, width, bits, ARF_RND_DOWN);
  arf_add(high, estimate, width, bits, ARF_RND_UP);
  tp_limit_outcome outcome = prove_held(proven, reduction, r, low);
  if (*proven) {
    outcome = tp_reduced_side(&side, &loss, r, high, -1);
    *proven = outcome == TP_LIMIT_PROVEN && side < 0;
  }
  if (*proven &&
      loss.known) { /* else it lies beyond the limit at the lower end, whose motion it is */
    reduction->has_motion = true;
    reduction->motion = loss.motion;
  }
  if (*proven) {
    arb_set_arf(reduction->factor, estimate);
    arf_mul_2exp_si(width, width, 1); /* the rounded ends lie within */
    arf_get_mag(arb_radref(reduction->factor), width);
  }
  arf_clear(width);
  arf_clear(low);
  arf_clear(high);
  return outcome;
}

/* Widen about the estimate from so many bits until both sides are proven, to what is asked for.
 */
static tp_limit_outcome enclose(tp_reduction *reduction, tp_reduced *r, const arf_t about,
                                slong wanted, int digits) {
  const slong widest = (slong)tp_digits_bits(digits + 1) + 1;
  tp_limit_outcome outcome = TP_LIMIT_PROVEN;
  bool proven = false;
  for (; wanted >= widest && !proven; wanted -= 3) {
    if (outcome == TP_LIMIT_OUT_OF_MEMORY || outcome == TP_LIMIT_FAILED) break;
    outcome = prove_about(reduction, &proven, r, about, wanted);
  }
  return outcome == TP_LIMIT_PROVEN && !proven ? TP_LIMIT_OPEN : outcome;
}

/* From what doubles tell apart to what is asked for, or, for more digits than that, from some more
 * than are asked for. */
static slong narrowest(int digits) {
  enum { NARROWEST = 43, SPARE = 5 }; /* 2^-43 is about 10^-13 */
  const slong asked = (slong)tp_digits_bits(digits + 1) + 1;
  return asked < NARROWEST ? NARROWEST : asked + (slong)tp_digits_bits(SPARE);
}

/* Halve between two factors on proven sides alone, to 10^-digits of the factor and some bits
 * more: for limits too fine for doubles, and flat ones, on which secants go astray. */
static tp_limit_outcome halve(arf_t factor, tp_reduced *r, double least, double most, int digits) {
  enum { LEAST_BITS = 52, SPARE = 20 };
  const long bits = r->question->judge.bits;
  const long asked = (long)tp_digits_bits(digits) + SPARE;
  const slong wanted = asked > LEAST_BITS ? asked : LEAST_BITS;
  arf_t low, high, width;
  arf_init(low);
  arf_init(high);
  arf_init(width);
  arf_set_d(low, least);
  arf_set_d(high, most);
  tp_limit_outcome outcome = TP_LIMIT_PROVEN;
  int side = 1;
  while (outcome == TP_LIMIT_PROVEN && side != 0) { /* 0: as near as the rung can tell */
    arf_add(factor, low, high, bits, ARF_RND_NEAR);
    arf_mul_2exp_si(factor, factor, -1);
    arf_sub(width, high, low, bits, ARF_RND_UP);
    arf_mul_2exp_si(width, width, wanted);
    if (arf_cmp(width, factor) < 0 || arf_cmp(factor, low) <= 0 || arf_cmp(factor, high) >= 0) {
      break;
    }
    outcome = tp_reduced_side(&side, NULL, r, factor, 1);
    arf_set(side > 0 ? low : high, factor);
  }
  arf_clear(low);
  arf_clear(high);
  arf_clear(width);
  return outcome;
}

/* By doubles, and for many digits by secants from there. */
static tp_limit_outcome find_quickly(tp_reduction *reduction, tp_reduced *r, double low,
                                     double high, int digits) {
  enum { OF_DOUBLES = 11, SPARE = 10 };
  tp_limit_outcome outcome = TP_LIMIT_OPEN;
  arf_t about;
  arf_init(about);
  if (search(about, r, low, high)) {
    if (digits > OF_DOUBLES) (void)refine(about, r, digits + SPARE);
    outcome = enclose(reduction, r, about, narrowest(digits), digits);
  }
  arf_clear(about);
  return outcome;
}

/* On proven limits alone: those at both ends tell what kind of answer there is. */
static tp_limit_outcome find_surely(tp_reduction *reduction, tp_reduced *r, double low, double high,
                                    int digits) {
  int strong = 0, weak = 0;
  arf_t about;
  arf_init(about);
  arf_set_d(about, high);
  tp_limit_outcome outcome = tp_reduced_side(&weak, NULL, r, about, -1);
  if (weak <= 0 && (outcome == TP_LIMIT_PROVEN || outcome == TP_LIMIT_OPEN)) {
    arf_set_d(about, low);
    outcome = tp_reduced_side(&strong, NULL, r, about, 1);
  }
  reduction->kind = weak > 0 ? TP_REDUCTION_UNBOUNDED : TP_REDUCTION_NONE;
  if (strong > 0 && weak < 0) {
    reduction->kind = TP_REDUCTION_FACTOR;
    outcome = halve(about, r, low, high, digits);
    if (outcome == TP_LIMIT_PROVEN || outcome == TP_LIMIT_OPEN) {
      outcome = enclose(reduction, r, about, narrowest(digits), digits);
    }
  } else if (outcome == TP_LIMIT_PROVEN && weak <= 0 && strong >= 0) {
    outcome = TP_LIMIT_OPEN;
  }
  arf_clear(about);
  return outcome;
}

static tp_limit_outcome find(tp_reduction *reduction, tp_reduced *r, int digits) {
  reduction->kind = TP_REDUCTION_FACTOR;
  const tp_limit_outcome quick = find_quickly(reduction, r, least_factor, most_factor, digits);
  if (quick != TP_LIMIT_OPEN) return quick;
  return find_surely(reduction, r, least_factor, most_factor, digits);
}

void tp_reduction_init(tp_reduction *reduction) {
  reduction->kind = TP_REDUCTION_NONE;
  reduction->has_motion = false;
  arb_init(reduction->factor);
}

void tp_reduction_clear(tp_reduction *reduction) {
  arb_clear(reduction->factor);
}

tp_limit_outcome tp_reduction_find(tp_reduction *reduction, const tp_limit_question *question,
                                   tp_cones *cones, const arb_t degrees, int digits) {
  tp_reduced r = {.question = question, .cones = cones, .degrees = degrees};
  reduction->kind = TP_REDUCTION_NONE;
  if (cones->count == 0) return TP_LIMIT_PROVEN; /* a corner on a corner alone bears nothing */
  tp_scaled own;
  if (question->scaled == NULL && !tp_program_scaled(&own, question)) {
    return TP_LIMIT_OUT_OF_MEMORY;
  }
  r.given = question->scaled != NULL ? question->scaled : &own;
  tp_limit_outcome outcome = TP_LIMIT_OUT_OF_MEMORY;
  if (tp_scaled_copy(&r.reduced, r.given)) {
    tp_reduced_init(&r);
    outcome = find(reduction, &r, digits);
    tp_reduced_clear(&r);
    tp_scaled_clear(&r.reduced);
  }
  if (r.given == &own) tp_scaled_clear(&own);
  return outcome;
}
