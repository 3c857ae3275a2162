/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tilt test at several values of each of its settings: which these are, and what is made of the
 * answers. A setting whose finer values are nearer to the truth (a step, a tolerance, a damping
 * that is none of nature's, stiff contacts) goes from coarse to fine, and the finest two must
 * agree; a ratio of stiffnesses has no finer values, and all must. Two answers agree where both
 * brackets together are no wider than was asked: brackets are a quarter of that. */

#ifndef TP_TILT_CONVERGE_H
#define TP_TILT_CONVERGE_H

#include "rigid_body/body.h"
#include "topple_converge.h"

enum { TP_CONVERGE_MOST_LEVELS = 6 };

/* A test as it is run. */
typedef struct tp_converge_run {
  tp_converge_setting setting; /* the one that is varied, */
  double value;                /* to this */
  bool own;                    /* which is the scene's */
  tp_tilt_settings settings;
  bool weight_moves;                   /* of a path: on springs of a finite stiffness */
  double path_tolerance_deg;           /* 0: chosen */
  double step_tolerance, least_bounce; /* of rigid contacts */
} tp_converge_run;

/* The test as the scene has it, to a quarter of what is asked of angles. */
tp_converge_run tp_converge_own(const tp_tilt_settings *settings);

/* The runs of one setting from coarse to fine; 0 where its engine has no such setting, or it is 0
 * in the scene. */
size_t tp_converge_runs(tp_converge_run runs[TP_CONVERGE_MOST_LEVELS], tp_converge_setting setting,
                        const tp_converge_run *own, tp_converge_quantity quantity,
                        const tp_rigid_body *body);

/* Is no finer level needed: do the last two of so many agree, from the scene's own on? Of what has
 * no finer values, or costs little, all are run. */
bool tp_converge_settled(const tp_converge_level *levels, size_t count, double asked);

/* What the levels of one setting come to: the verdict and what stands beside it, from `setting`,
 * `first` and `count`. `asked` is in the unit of the answer. */
void tp_converge_judge(tp_converge_finding *finding, const tp_converge_level *levels, double asked);

/* The case's own summary, all its findings being judged. */
void tp_converge_summarise(tp_tilt_convergence_case *own);

#endif
