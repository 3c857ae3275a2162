/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A problem at one rung of the ladder: what all parts of a solve read and none of them writes. What
 * they find goes out as results, each with its own certainty (evaluation/certainty.h). */

#ifndef TP_EVALUATION_EVALUATION_H
#define TP_EVALUATION_EVALUATION_H

#include "block/moments.h"
#include "number/decimals.h"
#include "number/work.h"
#include "problem/problem.h"

/* Up to the second moment of an area. */
enum { TP_METRES = 4 };

typedef struct tp_evaluation {
  const tp_problem *problem;
  tp_rung rung;
  int digits;
  bool reduces_strength; /* for the factor of safety of the limit */
  bool tells_ranges;     /* which motions can begin at every tilt */
  tp_pivots_listed pivots;
  tp_moments moments;
  arb_t weight_per_area_pa;       /* on the mean plane, level; where friction depends on the load */
  arb_t friction_tangent;         /* where it does not */
  arb_t tilt_sine, tilt_cosine;   /* of the scene's tilt, where it gives one */
  arb_struct metres[TP_METRES];   /* the step of the lattice, its square and so on */
  double log2_extent;             /* of what a coordinate can be, m from the lattice's origin */
  const struct tp_loaded *loaded; /* of the direction in hand; NULL: the weight alone */
  tp_decimals *decimals; /* keeps texts where more digits are asked for than a double holds */
  tp_work *work;         /* counts that of the limit and the onset on all rungs; NULL: any */
} tp_evaluation;

/* With the moments; without loads, texts and a count of work. */
void tp_evaluation_init(tp_evaluation *evaluation, const tp_problem *problem, tp_rung rung,
                        const tp_solve_options *options);
void tp_evaluation_clear(tp_evaluation *evaluation);

/* Precision of the arithmetic before functions are taken: sums and products of exact integers stay
 * exact on the last rungs. */
long tp_evaluation_bits(const tp_evaluation *evaluation);

/* Has no rung of the ladder more bits? What is open there stays undecided. */
bool tp_evaluation_is_last_rung(const tp_evaluation *evaluation);

/* The moments of the block as it is, with arcs and rounded corners, into an initialised
 * `moments`. Sums at the rung's level, or exactly where that is allowed by it and cheaper. */
void tp_evaluate_moments(tp_moments *moments, const tp_problem *problem, tp_rung rung);

/* A point of the outline in lattice units. */
void tp_evaluation_point(arb_t x, arb_t y, const tp_evaluation *evaluation, tp_outline_point at);

/* The axis of turning about the k-th contact point likewise. */
void tp_evaluation_axis(arb_t x, arb_t y, const tp_evaluation *evaluation, long k);

/* From one end of a facet to the other, in lattice units. */
void tp_evaluation_facet(arb_t dx, arb_t dy, const tp_evaluation *evaluation,
                         const tp_facet *facet);

/* A quantity of the lattice times step^degree, from 1 to TP_METRES: in metres to that power. */
void tp_evaluation_to_metres(arb_t value, const tp_evaluation *evaluation, int degree);

/* The block's weight in newton. */
void tp_evaluation_weight(arb_t newton, const tp_evaluation *evaluation);

#endif
