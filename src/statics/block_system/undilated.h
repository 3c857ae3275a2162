/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of joints that do not dilate as they slip: an estimate, without a bound.
 *
 * Limit analysis lets joints open by their friction angle as they slip, so its factor is an upper
 * bound, which is far too high where columns rotate against each other. Here the strength of each
 * joint is a fixed shear force: tan(phi) times the normal force of the round before, plus cohesion.
 * Then the mechanism slips without opening. Each round solves a linear program and moves the normal
 * forces towards those of its solution, until its factor settles (Gilbert, Casapulla and Ahmed
 * 2006, Computers & Structures 84, 861-877).
 *
 * With fixed shear forces, to divide all strengths by F is to multiply all loads by F: so the
 * factor by strength reduction is the greatest load too. Normal forces are those of the interior
 * point method, the centre of all that are optimal: those of a corner of the program leap from
 * round to round. A factor at which such forces hold need not be the only one, or the least. */

#ifndef TP_BLOCK_SYSTEM_UNDILATED_H
#define TP_BLOCK_SYSTEM_UNDILATED_H

#include "block_system/built_system.h"

typedef struct tp_undilated_task {
  const tp_built_system *system;
  const tp_weight_loads *loads;
  bool on_driving; /* the factor multiplies the live load; else it divides strengths */
  tp_near live;    /* if !on_driving: how much of the live load acts */
  double divisor;  /* where the rounds begin: forces of the program with friction, strengths divided
                      by it, at its greatest live load */
  const double *forces; /* borrowed, by column of that program; NULL: it is solved for them */
} tp_undilated_task;

typedef struct tp_undilated {
  bool has_factor; /* the rounds settled, or differ by little: */
  double factor;   /* the mean of the last ones */
  double spread;   /* the greatest of them less the least */
  long rounds;
} tp_undilated;

/* TP_OK without a factor where the rounds do not settle, nothing bounds the load, or there are more
 * contacts than TP_MOST_UNDILATED. */
enum { TP_MOST_UNDILATED = 6000 };
TP_MUST_USE tp_status tp_undilated_find(tp_undilated *undilated, const tp_undilated_task *task,
                                        tp_message *message);

#endif
