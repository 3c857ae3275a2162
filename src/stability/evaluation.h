/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One evaluation of a problem at one rung of the ladder: what its parts share. */

#ifndef TP_EVALUATION_H
#define TP_EVALUATION_H

#include "block/moments.h"
#include "number/decimals.h"
#include "number/work.h"
#include "stability/problem.h"

typedef struct tp_evaluation {
  const tp_problem *problem;
  tp_rung rung;
  int digits;
  tp_decimals *decimals; /* where more digits are asked for than a double holds; else NULL */
  bool reduces_strength; /* for the factor of safety of the limit */
  bool tells_ranges;     /* which motions can begin at every tilt */
  tp_moments moments;
  arb_t weight_per_area_pa; /* on the mean plane, level; zero where the block has no weight */
  bool certain;             /* all numbers and decisions so far */
  bool open_number; /* on the last rung: a number is not certain to the digits asked, and is given
                       with its bound, so that the others are not lost */
  bool *settled[2]; /* by direction: pivots all of whose numbers a lower rung made certain */
  tp_work *work;    /* of the limit on all rungs; NULL: any */
  long tie_bits; /* of the last tie that was compared: 0 where it is proven, else the bits that do
                    not tell the two apart */
  const struct tp_loaded *loaded; /* of the direction in hand; NULL: the weight alone */
} tp_evaluation;

/* A point of the outline in lattice units. */
void tp_evaluation_place(arb_t x, arb_t y, const tp_evaluation *evaluation, tp_outline_point at);

/* The axis of turning about the k-th contact point likewise. */
void tp_evaluation_axis(arb_t x, arb_t y, const tp_evaluation *evaluation, long k);

/* A point of the outline in metres of the scene. */
void tp_evaluation_place_metres(tp_bounded *x_m, tp_bounded *y_m, tp_evaluation *evaluation,
                                tp_outline_point at);

/* From one end of a facet to the other, in lattice units. */
void tp_evaluation_facet(arb_t dx, arb_t dy, const tp_evaluation *evaluation,
                         const tp_facet *facet);

/* Precision of the arithmetic before functions are taken: sums and products of exact integers stay
 * exact on the last rungs. */
long tp_evaluation_bits(const tp_evaluation *evaluation);

/* Has no rung of the ladder more bits? A verdict that is open there stays undecided. */
bool tp_evaluation_is_last_rung(const tp_evaluation *evaluation);

/* Does one angle in degrees lie above another by more than a millionth of a degree? Less is one
 * angle to who builds on it. */
bool tp_evaluation_is_above(tp_evaluation *evaluation, tp_bounded high, tp_bounded low);

/* The ball as a result, certain or not. */
tp_bounded tp_evaluation_bounded(const tp_evaluation *evaluation, const arb_t ball);

/* The ball as a result; notes where it is not certain enough. Where no rung is exact, a ball about
 * zero that is far narrower than the scale of the quantity, 2^log2_scale (1 for
 * tp_evaluation_result), is certain: a true zero is never known to any share of itself. */
tp_bounded tp_evaluation_result(tp_evaluation *evaluation, const arb_t ball);
tp_bounded tp_evaluation_result_scaled(tp_evaluation *evaluation, const arb_t ball,
                                       double log2_scale);

/* Likewise for a coordinate, which is certain as well where its bound is the asked share of the
 * block's size, 2^log2_size. */
tp_bounded tp_evaluation_result_within(tp_evaluation *evaluation, const arb_t ball,
                                       double log2_size);

/* Where no rung is exact: is the ball far narrower than the scale 2^log2_scale, so that what it
 * does not tell apart is taken for equal? */
bool tp_evaluation_is_zero_width(const tp_evaluation *evaluation, const arb_t ball,
                                 double log2_scale);

/* Likewise with a scale of 1 and from a higher rung on: for what decides which of two is named. */
bool tp_evaluation_is_settled(const tp_evaluation *evaluation, const arb_t ball);

/* An exact rational as a result. */
tp_bounded tp_evaluation_rational(const fmpq_t value);

/* A quantity of the lattice times step^degree, in metres to that power; `value` becomes that. */
tp_bounded tp_evaluation_metres(tp_evaluation *evaluation, arb_t value, int degree);

/* The block's weight in newton. */
void tp_evaluation_weight(arb_t newton, const tp_evaluation *evaluation);

/* Coordinates of a lattice point in metres. */
tp_bounded tp_evaluation_x(const tp_problem *problem, long point);
tp_bounded tp_evaluation_y(const tp_problem *problem, long point);

/* An angle by its direction: tan(angle) = sine / cosine, unnormalised. On exact rungs exact. */
typedef struct tp_direction_ball {
  arb_t sine, cosine;
  arb_t degrees;
  bool exact_direction; /* sine and cosine enclose the direction of `degrees` itself */
  bool adds_friction;   /* `degrees` is this inclination and the scene's friction angle added: */
  arb_t inclination;
} tp_direction_ball;

void tp_direction_ball_init(tp_direction_ball *angle);
void tp_direction_ball_clear(tp_direction_ball *angle);

/* Sign of a - b in degrees. Where the balls overlap and both directions are exact, the sign of the
 * cross product decides, ties included; otherwise the evaluation is marked as not certain. */
int tp_evaluation_compare(tp_evaluation *evaluation, const tp_direction_ball *a,
                          const tp_direction_ball *b);

/* The moments of the block as it is, with arcs and rounded corners: into `moments`. Sums at the
 * rung's level, or exactly where that is allowed by it and cheaper. */
void tp_evaluate_moments(tp_evaluation *evaluation);

/* The block, its teeth and its contact. */
void tp_evaluate_block(tp_evaluation *evaluation, tp_solution *solution);
void tp_evaluate_contact(tp_evaluation *evaluation, tp_solution *solution);

/* What the coordinates lie along; once for all rungs. */
void tp_describe_frame(tp_solution *solution, const tp_problem *problem);

/* Pivots of one direction of tilt; the critical angle of the governing one is left in `toppling`,
 * where there is one. */
void tp_evaluate_pivots(tp_evaluation *evaluation, tp_case *result, tp_direction_ball *toppling);

/* Critical angle of turning about the k-th contact point. */
void tp_evaluate_turning(tp_evaluation *evaluation, tp_direction towards, long k,
                         tp_direction_ball *angle);

/* Critical angle of the governing pivot alone; false where no pivot is admissible. Of those with
 * the same angle, or with none, the least safe at the scene's tilt governs; of those alike in that
 * too, the one furthest down-dip. `*tie`: another one has the same angle. */
bool tp_evaluate_toppling(tp_evaluation *evaluation, tp_direction towards,
                          tp_direction_ball *toppling, size_t *governing, bool *tie);

/* Sliding of one direction; its critical angle is left in `sliding` unless it is never reached. */
void tp_evaluate_sliding(tp_evaluation *evaluation, tp_case *result, tp_direction_ball *sliding);

/* Whether a rounded toe rolls back from its critical angle, or goes over. */
void tp_evaluate_rolling(tp_evaluation *evaluation, tp_case *result,
                         const tp_direction_ball *toppling);

/* Whether the base can hold the governing pivot at its critical angle. */
void tp_evaluate_toe(tp_evaluation *evaluation, tp_case *result, const tp_direction_ball *toppling);

/* The static limit of one direction, with the scene's base and otherwise, and that of tilting back;
 * the angles are left in `limit` and `back` where there are any. False when memory is exhausted. */
TP_MUST_USE bool tp_evaluate_limit(tp_evaluation *evaluation, tp_case *result,
                                   tp_direction_ball *limit, tp_direction_ball *back);

/* The limit, that of tilting back, and the onset of motion (stability/onset.h). */
typedef struct tp_statics {
  const tp_direction_ball *limit, *back;
  const struct tp_onset_found *onset;
} tp_statics;

/* The mechanism of one direction, from the limit and the onset of motion, or where no friction is
 * given from the critical angle of toppling. */
void tp_evaluate_mechanism(tp_evaluation *evaluation, tp_case *result,
                           const tp_direction_ball *toppling, const tp_direction_ball *sliding,
                           const tp_statics *statics);

/* The account of moments by elements about the governing pivot. `result->account.elements` has room
 * for all of them. */
void tp_evaluate_account(tp_evaluation *evaluation, tp_case *result,
                         const tp_direction_ball *toppling);

#endif
