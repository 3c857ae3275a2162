/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moments of a section at a rung: the ring sums less arcs and rounded corners. */

#include "stability/evaluation.h"

/* Integers up to about this size are summed faster exactly than in balls (measured: 90 against 290
 * ns a vertex at 40 bits, even at 300). */
enum { EXACT_IS_CHEAPER = 256 };

void tp_evaluate_moments(tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  const fmpq *metres_per_unit = problem->scene->metres_per_unit;
  tp_rung rung = e->rung;
  if (rung.level == TP_LEVEL_BALL && problem->lattice.bits <= EXACT_IS_CHEAPER) {
    rung.level = TP_LEVEL_EXACT;
  }
  tp_moments_evaluate(&e->moments, &problem->section, &problem->lattice, metres_per_unit, rung,
                      TP_SUM_COUNT);
  if (problem->section.arc_tips.count > 0) {
    tp_arcs_take_off(&e->moments, &problem->section, &problem->lattice, metres_per_unit, rung.bits);
  }
  if (problem->corners.count > 0) {
    tp_corners_take_off(&e->moments, &problem->corners, &problem->section, &problem->lattice,
                        rung.bits);
  }
}
