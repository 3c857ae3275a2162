/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact, the block's inertia and its loads put as a question to motion/. */

#ifndef TP_ONSET_ONSET_QUESTION_H
#define TP_ONSET_ONSET_QUESTION_H

#include "evaluation/evaluation.h"
#include "load/loads.h"
#include "motion/motion.h"

/* A question and what it points to; its own friction is that of its cones, zero to begin with. */
typedef struct tp_onset_asked {
  tp_motion_question question;
  tp_cones cones;  /* in lattice units */
  tp_cones strong; /* in metres, with cohesion and bonds, where there are any */
  bool took_zero;  /* by its judge */
} tp_onset_asked;

/* With the cones of `known`, which are taken from there, or where it has none, or is NULL, with new
 * ones. False when memory is exhausted. */
TP_MUST_USE bool tp_onset_asked_init(tp_onset_asked *asked, const tp_evaluation *evaluation,
                                     tp_direction towards, tp_cones *known);
void tp_onset_asked_clear(tp_onset_asked *asked);

/* Does a load act at the centroid: weight, earthquake? */
bool tp_onset_load_is_central(const tp_load *load);

/* Put other loads in place of those of the question: their sum, and the sum of those that do not
 * act at the centroid, or NULL where all do. */
void tp_onset_question_load(tp_motion_question *question, const tp_evaluation *evaluation,
                            tp_direction towards, const tp_wrench *all, const tp_wrench *others);

/* Does cohesion or a bond act? */
bool tp_onset_has_strength(const tp_evaluation *evaluation);

#endif
