/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The values for which a claim is meant.
 *
 * A symbol with a positive value at the claim takes all positive values, one with a negative value
 * all negative ones, one that is zero all; an angle between 0 and 90 degrees takes all of these,
 * any other all. A `domain` of the claims file says otherwise: bounds of a symbol, which may be
 * formulas in symbols bounded before it. A derived direction is meant in its quadrant at the claim.
 *
 * Every symbol is written in one number t > 0: x = t, x = low + t, x = (low + high t)/(1 + t); of
 * an angle u = tan(angle/2) is, and sin = 2u/(1 + u^2), cos = (1 - u^2)/(1 + u^2). A polynomial
 * that then has coefficients of one sign alone keeps that sign on the whole domain. */

#ifndef TP_VERIFY_DOMAIN_H
#define TP_VERIFY_DOMAIN_H

#include "verify/domain_images.h"
#include "verify/sample.h"

struct tp_domain {
  const tp_subject *subject;
  long symbol_count;
  int *signs;       /* by symbol without bounds: of its value at the claim */
  tp_images images; /* of the symbols, in terms of t */
  long bounds_count, bounds_capacity;
  tp_domain_bounds *bounds;
};

/* The domain about a claim's values; NULL when memory is exhausted. */
tp_domain *tp_domain_new(const tp_subject *subject, const tp_claim_sample *sample);
void tp_domain_free(tp_domain *domain);

/* Bound a symbol: takes the formulas over. Bad input where the claim's own value is outside;
 * `place` says where the bounds stand. */
TP_MUST_USE tp_status tp_domain_bound(tp_domain *domain, const tp_domain_bounds *bounds,
                                      const tp_claim_sample *sample, tp_place place,
                                      tp_message *message);

/* 1 or -1 where the formula is nowhere below, or above, zero on the domain, 0 where this is not
 * known; with `strict`, and nowhere zero. */
int tp_domain_sign(const fmpz_mpoly_q_t formula, const tp_domain *domain, bool strict);

/* The bounds of a symbol, the angle whose degrees it is; NULL: none. */
const tp_domain_bounds *tp_domain_bounds_of(const tp_domain *domain, long symbol);
const tp_angle *tp_domain_angle_of(const tp_domain *domain, long symbol);

/* A bound at a sample; false where it has no value there. */
bool tp_domain_bound_at(fmpq_t value, const fmpz_mpoly_q_t bound, const tp_domain *domain,
                        const tp_claim_sample *sample);

/* Move a sample within the domain, by a fixed sequence of numbers: by up to 15 % for a seed below
 * TP_DOMAIN_NEAR, from one end to the other for the others. False where it does not get inside. */
enum { TP_DOMAIN_NEAR = 24 };
TP_MUST_USE bool tp_domain_scatter(tp_claim_sample *sample, const tp_domain *domain, unsigned seed);

/* The range of an angle, in degrees; false where it takes any value. */
bool tp_domain_angle(double *low, double *high, const tp_domain *domain, long angle);

/* Is a sample inside? */
bool tp_domain_holds(const tp_domain *domain, const tp_claim_sample *sample);

#endif
