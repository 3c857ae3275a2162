/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The one rule for factors of safety: which factor governs, and whether a required factor is met.
 *
 * A state is one direction, azimuth and load case of a block, of many blocks or of a solid. For
 * each mechanism that can begin in it there are two factors (docs/mechanics.md, "Factor of
 * safety"): on driving loads and by strength reduction. Each is known by two proven bounds,
 * whatever arithmetic they come from. The factor of the state is the least of them. Hence its lower
 * bound is the least lower bound, and its upper bound the least upper bound: an unknown factor is
 * never discarded in favour of a number, and a known one is kept where its counterpart is unknown.
 */

#ifndef TP_VERDICT_SAFETY_H
#define TP_VERDICT_SAFETY_H

#include "topple_governing.h"

/* Can a motion begin in a state? From the most severe on. */
typedef enum tp_motion_verdict {
  TP_VERDICT_COLLAPSES, /* no contact forces hold it */
  TP_VERDICT_CAN_MOVE,  /* forces can hold it, but a motion can begin */
  TP_VERDICT_OPEN,      /* neither is proven */
  TP_VERDICT_STANDS     /* no motion can begin */
} tp_motion_verdict;

/* Proven bounds of one factor. Nothing is known from below where `least` is 0, nor from above where
 * `most` is infinite; both are infinite where the mechanism cannot begin at any multiple. */
typedef struct tp_factor_range {
  tp_fos_definition definition;
  tp_mechanism mechanism;
  double least, most;
} tp_factor_range;

/* A number with its bound, as a range. */
tp_factor_range tp_factor_range_of(tp_fos_definition definition, tp_mechanism mechanism,
                                   tp_fos fos);

/* The factor of safety of a state. */
typedef struct tp_safety {
  tp_motion_verdict verdict;
  double least, most; /* proven bounds of the factor, consistent with the verdict */
  bool has_factor;    /* one of the ranges bounds it from above: */
  size_t factor;      /* if has_factor: the index of the range with the least upper bound */
} tp_safety;

/* The least of `count` factors of a state. Where a motion can begin the factor is at most 1, where
 * none can it is at least 1. */
tp_safety tp_safety_of(tp_motion_verdict verdict, const tp_factor_range *ranges, size_t count);

/* As a factor of safety: a number where both bounds agree to TP_SAFETY_WIDTH of it, unbounded where
 * both are infinite, undefined where no factor is above 0, else undecided. */
#define TP_SAFETY_WIDTH 1e-3
tp_fos tp_safety_fos(const tp_safety *safety);

/* Is a required factor met? Never where a motion can begin or may begin at a smaller factor. */
tp_design tp_safety_meets(const tp_safety *safety, double required);

/* The order of severity: below 0 if `a` is more severe than `b`. States in which a motion can begin
 * come first, then undecided ones, then those with the smaller upper bound of the factor, then
 * those with the smaller lower bound. */
int tp_safety_compare(const tp_safety *a, const tp_safety *b);

/* The index of the most severe of `count` > 0 states; the first of equals. */
size_t tp_safety_governing(const tp_safety *states, size_t count);

/* The factor over all states: the least of theirs, with the verdict of the most severe. `factor` is
 * the one of the governing state. */
tp_safety tp_safety_of_all(const tp_safety *states, size_t count);

#endif
