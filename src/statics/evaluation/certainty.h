/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Balls as results, and whether these are certain.
 *
 * `Open` is what balls of this rung do not tell and those of a higher one may; `undecided` what no
 * rung of the ladder has told. Every part of a solve hands out the certainty of its own results
 * beside them; what it calls for them adds to it. */

#ifndef TP_EVALUATION_CERTAINTY_H
#define TP_EVALUATION_CERTAINTY_H

#include "evaluation/evaluation.h"

/* To begin with all of it is certain: {0}. */
typedef struct tp_certainty {
  bool open;             /* a number or a decision */
  bool undecided_number; /* on the last rung: not certain to the digits asked, and given with its
                            bound, so that the others are not lost */
  long zero_bits;        /* 0: every decision is proven; else one took for zero what so many bits do
                            not tell from it */
} tp_certainty;

/* What the one does not know the sum does not. */
void tp_certainty_add(tp_certainty *sum, const tp_certainty *own);

/* Open where the ladder has a higher rung; on its last rung what the caller says stays undecided,
 * and the climb ends. */
void tp_certainty_leave_open(tp_certainty *certainty, const tp_evaluation *evaluation);

/* The ball as a result, certain or not. */
tp_bounded tp_result_of(const tp_evaluation *evaluation, const arb_t ball);

/* The ball as a result that is to be certain to the digits asked. Where no rung is exact, a ball
 * about zero that is far narrower than the scale of the quantity, 2^log2_scale (1 for tp_result),
 * is certain: a true zero is never known to any share of itself. */
tp_bounded tp_result(const tp_evaluation *evaluation, const arb_t ball, tp_certainty *certainty);
tp_bounded tp_result_scaled(const tp_evaluation *evaluation, const arb_t ball, double log2_scale,
                            tp_certainty *certainty);

/* Likewise for a coordinate, which is certain as well where its bound is the asked share of the
 * block's size, 2^log2_size. */
tp_bounded tp_result_within(const tp_evaluation *evaluation, const arb_t ball, double log2_size,
                            tp_certainty *certainty);

/* A quantity of the lattice times step^degree, in metres to that power; `value` becomes that. */
tp_bounded tp_result_metres(const tp_evaluation *evaluation, arb_t value, int degree,
                            tp_certainty *certainty);

/* A point of the outline in metres of the drawing (problem/drawn.h). */
void tp_result_point(tp_bounded *x_m, tp_bounded *y_m, const tp_evaluation *evaluation,
                     tp_outline_point at, tp_certainty *certainty);

/* A point of the problem in metres, which becomes that of the drawing, as a result certain to the
 * asked share of the block's size, 2^log2_size, or to the digits asked. */
void tp_result_place(tp_bounded *x_m, tp_bounded *y_m, const tp_evaluation *evaluation, arb_t x,
                     arb_t y, double log2_size, tp_certainty *certainty);

/* A lattice point in metres of the drawing, one that is given exactly in metres of the problem, and
 * an exact rational, as results. */
void tp_result_lattice_point(tp_bounded *x_m, tp_bounded *y_m, const tp_problem *problem,
                             long point);
void tp_result_exact_place(tp_bounded *x_m, tp_bounded *y_m, const tp_problem *problem, fmpq_t x,
                           fmpq_t y);
tp_bounded tp_result_rational(const fmpq_t value);

/* Does one angle in degrees lie above another by more than a millionth of a degree? Less is one
 * angle to who builds on it. */
bool tp_result_is_above(const tp_evaluation *evaluation, tp_bounded high, tp_bounded low,
                        tp_certainty *certainty);

/* A decision took for zero what the rung's bits do not tell from it. */
void tp_certainty_take_zero(tp_certainty *certainty, const tp_evaluation *evaluation);

/* Where no rung is exact: is the ball far narrower than the scale 2^log2_scale, so that what it
 * does not tell apart is taken for equal? */
bool tp_is_zero_width(const tp_evaluation *evaluation, const arb_t ball, double log2_scale);

/* Likewise with a scale of 1 and from a higher rung on: for what decides which of two is named. */
bool tp_is_settled(const tp_evaluation *evaluation, const arb_t ball);

#endif
