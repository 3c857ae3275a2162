/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The stages of a solve at one precision, in the order in which stability/climb.c calls them. Each
 * reads the evaluation, fills in its part of the solution, and adds the certainty of that to the
 * one it is given. */

#ifndef TP_EVALUATION_STAGES_H
#define TP_EVALUATION_STAGES_H

#include "evaluation/direction_ball.h"
#include "evaluation/further.h"
#include "linear_program/cones.h"

/* What the coordinates lie along; once for all rungs. */
void tp_describe_frame(tp_solution *solution, const tp_problem *problem);
void tp_describe_rest(tp_solution *solution, const tp_problem *problem);
void tp_describe_joint(tp_solution *solution, const tp_problem *problem);
void tp_describe_within(tp_solution *solution, const tp_problem *problem);
void tp_describe_smoothed(tp_solution *solution, const tp_problem *problem);

/* The block: area, centroid, second moments, weight. */
void tp_evaluate_block(const tp_evaluation *evaluation, tp_block_result *block,
                       tp_certainty *certainty);

/* Its contact: where it ends, how long and steep it is, the weight on it where that is known. */
void tp_evaluate_contact(const tp_evaluation *evaluation, tp_contact_result *contact,
                         tp_certainty *certainty);

/* Critical angle of turning about the k-th contact point. */
void tp_evaluate_turning(const tp_evaluation *evaluation, tp_direction towards, long k,
                         tp_direction_ball *angle, tp_certainty *certainty);

/* The pivot that governs a direction of tilt. */
typedef struct tp_governing_pivot {
  bool found; /* false: no pivot is admissible */
  size_t index;
  bool tie;      /* another one has the same angle, */
  long tie_bits; /* as far as so many bits tell; 0: it is proven */
} tp_governing_pivot;

/* Critical angle of the governing pivot alone. Of those with the same angle, or with none, the
 * least safe at the scene's tilt governs; of those alike in that too, the one furthest down-dip. */
tp_governing_pivot tp_evaluate_toppling(const tp_evaluation *evaluation, tp_direction towards,
                                        tp_direction_ball *toppling, tp_certainty *certainty);

/* The pivots of a direction that are asked for, but those that are settled: a lower rung made all
 * their numbers certain. The critical angle of the governing one is left in `toppling`, where there
 * is one. */
void tp_evaluate_pivots(const tp_evaluation *evaluation, tp_case *result, bool *settled,
                        tp_direction_ball *toppling, tp_certainty *certainty);

/* Likewise the pivots that bear the limit, once that is found, which are listed now; and those that
 * it or the onset turns about, by their places alone. False when memory is exhausted. */
TP_MUST_USE bool tp_evaluate_bearing_pivots(const tp_evaluation *evaluation, tp_case *result,
                                            bool *settled, tp_certainty *certainty);

/* Whether a rounded toe rolls back from its critical angle, or goes over. */
void tp_evaluate_rolling(const tp_evaluation *evaluation, tp_case *result,
                         const tp_direction_ball *toppling, tp_certainty *certainty);

/* Sliding of one direction; its critical angle is left in `sliding` unless it is never reached. */
void tp_evaluate_sliding(const tp_evaluation *evaluation, tp_case *result,
                         tp_direction_ball *sliding, tp_certainty *certainty);

/* Whether the base can hold the governing pivot at its critical angle. */
void tp_evaluate_toe(const tp_evaluation *evaluation, tp_case *result,
                     const tp_direction_ball *toppling, tp_certainty *certainty);

/* The static limit of one direction, with the scene's base and otherwise, and that of tilting back;
 * the angles are left in `limit` and `back` where there are any; the same limits at further tilts,
 * with the factor of safety there. The contact is left in `cones`, which is empty, where the onset
 * has the same. False when memory is exhausted. */
TP_MUST_USE bool tp_evaluate_limit(const tp_evaluation *evaluation, tp_case *result,
                                   tp_direction_ball *limit, tp_direction_ball *back,
                                   const tp_further_tilts *tilts, tp_cones *cones,
                                   tp_certainty *certainty);

/* The onset of motion: onset/onset.h. */

/* What the mechanism is told by. */
typedef struct tp_statics {
  const tp_direction_ball *toppling, *sliding;
  const tp_direction_ball *limit, *back; /* by contact forces, and tilted back */
  const struct tp_onset_found *onset;
} tp_statics;

/* The mechanism of one direction, from the limit and the onset of motion, or where no friction is
 * given from the critical angle of toppling. */
void tp_evaluate_mechanism(const tp_evaluation *evaluation, tp_case *result,
                           const tp_statics *statics, tp_certainty *certainty);

/* The account of moments by elements about the governing pivot. `result->account.elements` has room
 * for all of them. */
void tp_evaluate_account(const tp_evaluation *evaluation, tp_case *result,
                         const tp_direction_ball *toppling, tp_certainty *certainty);

#endif
