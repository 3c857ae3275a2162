/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tilt test of one direction while it is made: the engine, what it is asked, what it came to. */

#ifndef TP_TILT_TILTING_H
#define TP_TILT_TILTING_H

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
  tp_body_state moves_off;           /* as it began to move at the least tilt so far */
  bool weight_moves;         /* with the springs of a path: not in the limit of stiff ones */
  double path_tolerance_deg; /* of a path; 0: chosen */
  const tp_tilt_test_description *asked; /* of the scene, for places; NULL: none */
  const tp_shaking_component *shaken;    /* its components; NULL: none */
  double search; /* budgets of a search for what overturns, of which a run has one; 0: none */
  double budgets, spent; /* allowed, 0: one; steps so far (tilt/cost.h) */
  tp_message why;        /* the last run that was undecided was so; empty: none was */
  tp_message *message;
} tp_tilting;

#endif
