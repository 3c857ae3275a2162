/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a climb of the ladder keeps from one rung to the next, and the same for the further tilts
 * that its first rung serves (evaluation/further.h). */

#ifndef TP_STABILITY_CLIMBING_H
#define TP_STABILITY_CLIMBING_H

#include "evaluation/further.h"
#include "onset/onset.h"
#include "stability/tilts.h"

/* What lower rungs have settled of one direction. */
typedef struct tp_direction_settled {
  bool *pivots; /* all numbers of each */
  bool limit, onset;
  tp_direction_ball limit_angle, back_angle; /* of the limit, and tilted back */
  tp_onset_found onset_found;
} tp_direction_settled;

typedef struct tp_climbing tp_climbing;
struct tp_climbing {
  tp_solution *solution;
  const tp_problem *problem;
  const tp_solve_options *options;
  tp_direction_settled settled[2]; /* by direction */
  tp_work work;
  tp_message *message;
  int rungs;                 /* tried so far */
  bool shares;               /* the first told all of its own tilt, */
  struct tp_at_tilt *others; /* and what it could of these */
  size_t other_count;
  tp_further_tilts tilts; /* those to be told at this rung, of the case in hand */
};

/* A further tilt: the scene, its problem and that at the first rung, all borrowed but for the
 * tilt. */
typedef struct tp_at_tilt {
  tp_scene scene;
  tp_problem problem;
  tp_evaluation evaluation;
  tp_climbing climbing;
  tp_certainty certainty;
} tp_at_tilt;

/* Of a solution whose cases are described. To be cleared also on failure. */
TP_MUST_USE tp_status tp_climbing_init(tp_climbing *climbing, tp_solution *solution,
                                       const tp_problem *problem, const tp_solve_options *options,
                                       const tp_tilts *tilts, tp_message *message);
void tp_climbing_clear(tp_climbing *climbing);

/* The further tilts at the first rung; and what they are told by of a case, under its loads or
 * NULL. */
void tp_climbing_begin_tilts(tp_climbing *climbing, const tp_evaluation *evaluation);
void tp_climbing_take_case(tp_climbing *climbing, size_t number, const struct tp_loaded *loaded);
/* The limit and the onset of a direction, as the scene's own tilt has them. */
void tp_climbing_share(tp_climbing *climbing, tp_direction towards);
/* The first rung is done. */
void tp_climbing_end_tilts(tp_climbing *climbing, bool certain);

/* Hand out the solutions of those that are told. */
void tp_climbing_hand_out(tp_tilts *tilts, tp_climbing *climbing);

#endif
