/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks on contact springs, for tests of that method. */

#ifndef TP_TEST_SPRINGS_STAGE_H
#define TP_TEST_SPRINGS_STAGE_H

#include "body_stage.h"
#include "contact_springs/springs.h"

/* The paper's: 1000 and 10 GPa/m, corners of 1e-7 m; local damping of 0.8. */
tp_spring_settings paper_springs(void);

double radians(double degrees);

/* Let go at a tilt, in degrees, where it lies: until it is sure to move, or rests. */
tp_run_end springs_at(const tp_rigid_body *body, double tilt_deg,
                      const tp_spring_settings *settings);

/* The tilt from which on it moves, by halving between two in degrees to less than 0.01 apart: the
 * upper one of the last two. */
double springs_let_go(const tp_rigid_body *body, double low_deg, double high_deg,
                      const tp_spring_settings *settings);

/* A slab 1 m wide, with a friction angle, a height and the points of its profile. */
#define SLAB(friction, height, base)                                                               \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: " friction                                       \
  "\nblock: {outline: [[0, 0], [1, 0], [1, " height "], [0, " height                               \
  "]], thickness: 2, unit_weight_kn_m3: 25}\nbase: {profile: [" base "]}\n"

#define LEVEL "[-20, 0], [20, 0]"

/* How a run ended, and its story: to be cleared by tp_history_clear. */
typedef struct spring_outcome {
  tp_run_end end;
  tp_body_state last;
  tp_history history;
} spring_outcome;

/* A run with the paper's springs but for the damping, and the step where that is not 0. */
spring_outcome springs_run(const body_stage *stage, const tp_drive *drive,
                           const tp_body_state *start, double longest_s, double damping,
                           double time_step_s);

/* From rest at a tilt, without damping. */
spring_outcome springs_run_held(const body_stage *stage, double tilt_deg, double longest_s);

/* The moment next after a time. */
const tp_tilt_moment *springs_moment(const tp_history *history, double time_s);

#endif
