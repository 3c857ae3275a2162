/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Runs of an engine of dynamics on the table, and what each tells of the block: does it stand? */

#ifndef TP_TILT_TRIAL_H
#define TP_TILT_TRIAL_H

#include "quasi_static/path.h"
#include "rigid_body/history.h"
#include "scene/tilt_test.h"
#include "topple_tilt_test.h"

/* An engine of dynamics with its settings. */
typedef struct tp_tilt_dynamics {
  tp_run_end (*run)(tp_body_state *last, const tp_run *run, void *engine, tp_message *message);
  void *engine;
} tp_tilt_dynamics;

/* A test of one direction under way. */
typedef struct tp_tilting {
  const tp_rigid_body *body;
  const tp_tilt_settings *settings;
  const tp_tilt_options *options;
  tp_tilt_dynamics engine;
  const tp_base_motion *shaking;     /* NULL: none */
  double shaking_s;                  /* how long it lasts */
  const tp_path_traction *tractions; /* of the path; NULL: none */
  tp_tilt_case *own;                 /* what is found */
  tp_history history;                /* that is told */
  tp_body_state moves_off;           /* as it let go at the least tilt so far */
  bool weight_moves;         /* with the springs of a path: not in the limit of stiff ones */
  double path_tolerance_deg; /* of a path; 0: chosen */
  const tp_tilt_test_description *asked; /* of the scene, for places; NULL: none */
  const tp_shaking_component *shaken;    /* its components; NULL: none */
  double budgets, spent;                 /* allowed, 0: one; steps so far (tilt/cost.h) */
  tp_message why; /* the last run that was undecided was so; empty: none was */
  tp_message *message;
} tp_tilting;

/* What a run says. */
typedef enum tp_tilt_verdict {
  TP_VERDICT_STANDS,
  TP_VERDICT_MOVES, /* also where it moved, and rests again elsewhere: cautious */
  TP_VERDICT_OPEN,
  TP_VERDICT_STOPPED
} tp_tilt_verdict;

/* At a tilt in degrees: a fresh start there, or from level at the table's speed and held. Until it
 * lets go, which `last` is then; `history` may be NULL. */
TP_MUST_USE tp_status tp_tilting_try(tp_tilt_verdict *verdict, tp_body_state *last,
                                     tp_tilting *tilting, double angle_deg, tp_history *history);

/* A run as it is, counted and timed. */
TP_MUST_USE tp_status tp_tilting_run(tp_run_end *end, tp_body_state *last, tp_tilting *tilting,
                                     const tp_run *run);

/* Did options.stop say so? */
bool tp_tilting_stopped(const tp_tilting *tilting);
/* Tell options.progress of the bracket. */
void tp_tilting_tell(const tp_tilting *tilting, double least_deg, double most_deg);

double tp_tilt_radians(double degrees);
double tp_tilt_degrees(double radians);

#endif
